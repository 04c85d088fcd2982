#include "program_run.h"

#include <chrono>
#include <csignal>
#include <thread>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ; // NOLINT: POSIX

namespace limner {
namespace {

using testing::WithScan;

/// The program itself, as a user starts it.
class Process {
  public:
    explicit Process(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), LIMNER_PROGRAM);
        std::vector<char*> raw;
        for (std::string& argument : arguments) {
            raw.push_back(argument.data());
        }
        raw.push_back(nullptr);
        posix_spawn_file_actions_t actions;
        ::posix_spawn_file_actions_init(&actions);
        ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
        ::posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
        EXPECT_EQ(::posix_spawn(&id_, LIMNER_PROGRAM, &actions, nullptr, raw.data(), environ), 0);
        ::posix_spawn_file_actions_destroy(&actions);
    }

    void signal(int number) const { ::kill(id_, number); }

    [[nodiscard]] bool running() {
        if (!ended_) {
            ended_ = ::waitpid(id_, &status_, WNOHANG) == id_;
        }
        return !ended_;
    }

    int wait() {
        if (!ended_) {
            ::waitpid(id_, &status_, 0);
            ended_ = true;
        }
        return WIFEXITED(status_) ? WEXITSTATUS(status_) : -WTERMSIG(status_);
    }

  private:
    pid_t id_ = 0;
    int status_ = 0;
    bool ended_ = false;
};

bool writesAPicture(const std::filesystem::path& folder) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() == ".part") {
            return true;
        }
    }
    return false;
}

TEST_F(WithScan, WithoutOpenGlTheProgramEndsWithFour) {
    ASSERT_EQ(::setenv("MESA_GL_VERSION_OVERRIDE", "3.3", 1), 0); // a Mesa too old for the backend
    Process program({"render", scan(), "-o", path("gl.png"), "--backend", "gl", "--gl", "osmesa"});
    ::unsetenv("MESA_GL_VERSION_OVERRIDE");
    EXPECT_EQ(program.wait(), 4);
    EXPECT_FALSE(std::filesystem::exists(path("gl.png")));
}

TEST_F(WithScan, CtrlCEndsALongRenderWith130AndLeavesNoFile) {
    for (const int signal : {SIGINT, SIGTERM}) {
        // Minutes of work on any machine.
        Process limner({"render", scan(), "-o", path("out.tif"), "--size", "60000x60000", "--set",
                        "/quality/samples_per_pixel=16"});
        while (limner.running() && !writesAPicture(folder_)) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        ASSERT_TRUE(limner.running()) << "ended with " << limner.wait();
        limner.signal(signal);
        EXPECT_EQ(limner.wait(), 130);
        EXPECT_EQ(filesLeft(), 1U) << "only the scan may be there";
    }
}

TEST_F(WithScan, CtrlCAtAnyMomentLeavesNoFile) {
    for (int delayMs = 0; delayMs <= 300; delayMs += 30) {
        Process limner({"render", scan(), "-o", path("out.png"), "--size", "9000x9000"});
        std::this_thread::sleep_for(std::chrono::milliseconds(delayMs));
        limner.signal(SIGINT);
        const int code = limner.wait();
        // Before the program has set up its handler the system ends it.
        EXPECT_TRUE(code == 130 || code == -SIGINT) << code;
        EXPECT_EQ(filesLeft(), 1U) << delayMs;
    }
}

} // namespace
} // namespace limner

#pragma once

#include <bitset>
#include <cstddef>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

namespace limner {

struct RenderPlan;

/// What a picture is drawn without because its figure cannot show it (spec accuracy.md 1.10), one home for all of it.
/// A part that a figure has not is another thing: nobody asked for it, and no plan has ever had it.
enum class LeaveOut {
    layers,
    importance,
    importanceOutsideLenses,
    importanceOfRest,
    normals,
    curvature,
    emptySpace,
    restOfRay,
    wideVoxels,
    mipLevels,
    dotFactors,
    colourLookups,
};
inline constexpr std::size_t kLeaveOutRules = 12;

/// What leaving out may do to a picture.
enum class LeaveOutEquality {
    sameBits,
    rounding,  ///< sums of the same terms in another order or form: some units in the last place of a sample
    tolerance, ///< no more than the figure's early termination
};

struct LeaveOutRule {
    LeaveOut what;
    const char* id;        ///< of one word, for machines: "empty-space"
    const char* name;      ///< "samples of empty blocks"
    const char* condition; ///< exact, when it is left out
    LeaveOutEquality equality;
};

/// In the order of the enumeration.
std::span<const LeaveOutRule> leaveOutRules();
const LeaveOutRule& ruleOf(LeaveOut what);

/// "same bits", ...
const char* nameOf(LeaveOutEquality equality);

/// Rules that are switched off: what they would leave out stays in.
class KeptIn {
  public:
    KeptIn() = default;
    KeptIn(std::initializer_list<LeaveOut> rules) {
        for (const LeaveOut rule : rules) {
            rules_.set(static_cast<std::size_t>(rule));
        }
    }
    static KeptIn everything() {
        KeptIn all;
        all.rules_.set();
        return all;
    }
    /// All rules that leave the bits as they are.
    static KeptIn allOf(LeaveOutEquality equality);

    [[nodiscard]] bool has(LeaveOut rule) const { return rules_.test(static_cast<std::size_t>(rule)); }
    friend bool operator==(const KeptIn&, const KeptIn&) = default;

  private:
    std::bitset<kLeaveOutRules> rules_;
};

/// A rule at work in a plan.
struct LeftOut {
    LeaveOut rule;
    std::string what; ///< "93 % of the blocks"
};

/// Whether rays sample the voxels of an eight-bit scan as they are.
bool samplesEightBits(const RenderPlan& plan);

/// The rules whose condition a plan meets and that are not switched off.
std::vector<LeftOut> rulesAtWork(const RenderPlan& plan);

} // namespace limner

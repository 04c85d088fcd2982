#!/usr/bin/env python3
"""Holds every #include against the table of folders: who may include whom, and where a library may be seen."""

import re

from checking import Planted, run, sources

# Libraries by the shape of their headers. First match wins; what matches nothing is the standard library's.
LIBRARIES = (
    ("qt", r"Q[A-Z]\w*$|Qt\w*/"),
    ("gl", r"(GL|GLES\d?|EGL|KHR|epoxy|glad)/|GL\w*\.h$"),
    ("vtk", r"vtk\w+\.h$"),
    ("itk", r"itk\w+\.h(xx)?$|itksys/|gdcm\w+\.h$"),
    ("oiio", r"OpenImageIO/"),
    ("lcms", r"lcms2\.h$"),
    ("fonts", r"hb(-\w+)?\.h$|freetype/|fontconfig/"),
    ("opencv", r"opencv2/"),
    ("json", r"nlohmann/"),
    ("zip", r"zip\.h$"),
    ("zlib", r"(zlib|bzlib)\.h$"),
    ("expat", r"expat\.h$"),
    ("openssl", r"openssl/"),
    ("cli11", r"CLI/"),
    ("hwy", r"hwy/"),
    ("tbb", r"tbb/|oneapi/"),
    ("glm", r"glm/"),
    ("mpi", r"mpi\.h$"),
    ("test", r"gtest/|gmock/|benchmark/"),
    ("system", r"(sys|linux)/|(unistd|fcntl|signal|termios|poll|dirent|pwd|dlfcn)\.h$"),
    ("files", r"(fstream)$"),
)

# folder -> (own folders it may include, libraries its headers may show, libraries its sources may use besides).
# The longest prefix of a file's path counts. "files" is reading and writing files by streams.
RULES = {
    "core": (("core",), {"glm"}, {"tbb", "files"}),
    "core/base": (("core/base",), set(), {"system", "files"}),
    "core/volume": (
        ("core",),
        {"glm"},
        {"tbb", "itk", "oiio", "zlib", "expat", "openssl", "json", "system", "files"},
    ),
    "core/style": (("core",), {"glm"}, {"tbb", "oiio", "opencv", "lcms", "json", "files", "system"}),
    "core/optics": (("core/base", "core/optics"), {"glm"}, set()),
    "core/figure": (("core",), {"glm"}, {"tbb", "json", "files"}),
    "core/project": (("core",), {"glm"}, {"json", "zip", "zlib", "openssl", "oiio", "system", "files"}),
    "renderer": (("core", "renderer"), {"glm"}, {"tbb", "hwy"}),
    "renderer/accuracy": (("core", "renderer"), {"glm"}, {"tbb", "json", "opencv", "files"}),
    "renderer/cpu": (("core", "renderer"), {"glm", "hwy"}, {"tbb"}),
    "renderer/gl": (("core", "renderer"), {"glm", "gl"}, {"tbb", "system"}),
    "renderer/export": (("core", "renderer"), {"glm"}, {"tbb", "oiio", "lcms", "qt", "zlib", "system", "files"}),
    "renderer/text": (("core", "renderer/text"), {"glm"}, {"fonts"}),
    "renderer/distributed": (("core", "renderer"), {"glm"}, {"tbb", "mpi", "system"}),
    "widgets": (
        (
            "core",
            "widgets",
            "renderer/*.h",
            "renderer/accuracy/*.h",
            "renderer/plan/*.h",
            "renderer/export/*.h",
            "renderer/interactive/*.h",
        ),
        {"glm", "qt"},
        {"tbb"},
    ),
    "app/cli": (("core", "renderer", "app/cli"), {"glm"}, {"cli11", "json", "tbb", "system", "files"}),
    "app/studio": (("core", "renderer", "widgets", "app/studio"), {"glm", "qt"}, {"tbb", "system"}),
    "tests": (("core", "renderer", "widgets", "app", "tests", "support"), None, None),  # None: anything
}

# Writing to the file system without a stream, where files are out of bounds.
WRITING = re.compile(r"filesystem::(create_director|remove|rename|copy|resize_file|permissions|last_write_time)")
WRITING_QT = re.compile(r"(QFile|QSaveFile|QTemporaryFile|QTemporaryDir|QTextStream|QDataStream|QDir)$")
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)


def library_of(header):
    for name, shape in LIBRARIES:
        if re.match(shape, header):
            return name
    return None


def rule_of(path):
    parts = path.parts[:-1]
    for length in range(len(parts), 0, -1):
        rule = RULES.get("/".join(parts[:length]))
        if rule:
            return rule
    return None


def own_folder_allows(allowed, header):
    for folder in allowed:
        if folder.endswith("/*.h"):
            if re.fullmatch(re.escape(folder[:-4]) + r"/[^/]+\.h", header):
                return True
        elif header.startswith(folder + "/"):
            return True
    return False


def problems_of(root, path):
    rule = rule_of(path)
    if rule is None:
        return [f"{path}: no rule for this folder"]
    own, in_headers, in_sources = rule
    if in_headers is None:
        return []
    text = (root / path).read_text(encoding="utf-8")
    libraries = in_headers if path.suffix == ".h" else in_headers | in_sources
    problems = []
    for _, header in INCLUDE.findall(text):
        top = header.split("/")[0]
        if top in ("core", "renderer", "widgets", "app", "tests"):
            if not own_folder_allows(own, header):
                problems.append(f"{path}: may not include {header}")
            continue
        library = library_of(header)
        if library and library not in libraries:
            problems.append(f"{path}: {library} may not be seen here ({header})")
        elif path.parts[0] == "widgets" and WRITING_QT.match(header):
            problems.append(f"{path}: widgets touch no files ({header})")
        elif not library and "/" not in header and "." in header and not is_c_header(header):
            problems.append(f"{path}: {header} is neither a known library's nor named by its path from the repository's root")
    if path.parts[0] == "widgets" and WRITING.search(text):
        problems.append(f"{path}: widgets touch no files ({WRITING.search(text).group()})")
    return problems


def is_c_header(header):
    return header in {"immintrin.h", "smmintrin.h", "malloc.h"} or header.endswith(".moc") or header.startswith("ui_")


def check(root):
    return [problem for path in sources(root) for problem in problems_of(root, path)]


PLANTED = (
    Planted("core/volume/a.cpp", "#include <QString>\n", "qt may not be seen here"),
    Planted("core/figure/a.cpp", "#  include <QtGui/QImage>\n", "qt may not be seen here"),
    Planted("core/style/a.h", "#include <GL/gl.h>\n", "gl may not be seen here"),
    Planted("core/volume/a.h", "#include <itkImage.h>\n", "itk may not be seen here"),
    Planted("core/figure/a.h", "#include <nlohmann/json.hpp>\n", "json may not be seen here"),
    Planted("core/style/b.h", "#include <opencv2/core.hpp>\n", "opencv may not be seen here"),
    Planted("core/volume/b.h", "#include <OpenImageIO/imageio.h>\n", "oiio may not be seen here"),
    Planted("core/volume/c.cpp", "#include <hwy/highway.h>\n", "hwy may not be seen here"),
    Planted("core/volume/d.cpp", '#include "renderer/picture.h"\n', "may not include renderer/picture.h"),
    Planted("core/base/a.cpp", '#include "core/volume/grid.h"\n', "may not include core/volume/grid.h"),
    Planted("core/optics/a.h", '#include "core/figure/figure.h"\n', "may not include core/figure/figure.h"),
    Planted("renderer/plan/a.cpp", "#include <itkImage.h>\n", "itk may not be seen here"),
    Planted("renderer/cpu/a.cpp", "#include <QImage>\n", "qt may not be seen here"),
    Planted("renderer/plan/a.h", "#include <hwy/highway.h>\n", "hwy may not be seen here"),
    Planted("renderer/plan/b.cpp", '#include "widgets/viewport.h"\n', "may not include widgets/viewport.h"),
    Planted("renderer/text/a.h", "#include <hb-ot.h>\n", "fonts may not be seen here"),
    Planted("widgets/a.cpp", "#include <gdcmReader.h>\n", "itk may not be seen here"),
    Planted("widgets/b.cpp", "#include <fstream>\n", "files may not be seen here"),
    Planted("widgets/c.cpp", "#include <QSaveFile>\n", "widgets touch no files"),
    Planted("widgets/d.cpp", "void f() { std::filesystem::remove(p); }\n", "widgets touch no files"),
    Planted("widgets/e.cpp", '#include "renderer/cpu/ray_caster.h"\n', "may not include renderer/cpu/ray_caster.h"),
    Planted("widgets/f.cpp", "#include <QtOpenGL/QOpenGLWindow>\n#include <GL/gl.h>\n", "gl may not be seen here"),
    Planted("app/cli/a.cpp", "#include <QApplication>\n", "qt may not be seen here"),
    Planted("app/cli/b.cpp", '#include "widgets/viewport.h"\n', "may not include widgets/viewport.h"),
    Planted("app/studio/a.cpp", "#include <itkImage.h>\n", "itk may not be seen here"),
    Planted("core/volume/e.cpp", '#include "grid.h"\n', "nor named by its path from the repository's root"),
    Planted("app/elsewhere/a.cpp", "int x;\n", "no rule for this folder"),
)
INNOCENT = {
    "core/volume/a.cpp": '#include "core/base/error.h"\n#include <itkImage.h>\n#include <vector>\n',
    "renderer/cpu/a.h": "#include <hwy/highway.h>\n",
    "widgets/a.h": '#include "renderer/backend.h"\n#include "renderer/plan/render_plan.h"\n#include <QWidget>\n',
    "tests/core/a_test.cpp": "#include <gtest/gtest.h>\n#include <nlohmann/json.hpp>\n",
}

if __name__ == "__main__":
    run(__doc__, check, PLANTED, INNOCENT)

# Flags and helpers that every folder uses.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
  # What ccache asks for before it keeps a file that was compiled with a precompiled header.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${CCACHE_PROGRAM})
endif()

# Flags shared by our own code; libraries' headers come in as SYSTEM and stay out of -Werror.
add_library(limner_flags INTERFACE)
target_include_directories(limner_flags INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(limner_flags INTERFACE -Wall -Wextra -Werror -Wshadow -Wnon-virtual-dtor)
if(LIMNER_SANITIZE)
  target_compile_options(limner_flags INTERFACE -O1 -g1) # a sanitizer's code at -O3 takes minutes a file
else()
  # The libraries under test are as users get them; the tests' own code (property LIMNER_TESTS_ONLY) need not be fast.
  target_compile_options(limner_flags INTERFACE
    $<$<NOT:$<CONFIG:Debug>>:$<IF:$<BOOL:$<TARGET_PROPERTY:LIMNER_TESTS_ONLY>>,-O1,-O3>>)
endif()
# GCC 12 sees overlaps that are not there in "/" + std::string (GCC bug 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(limner_flags INTERFACE -Wno-restrict)
  # The same where a test adds to the source folder's name and that is short enough to be kept in the string itself.
  target_compile_options(limner_flags INTERFACE $<$<BOOL:$<TARGET_PROPERTY:LIMNER_TESTS_ONLY>>:-Wno-array-bounds>
    $<$<BOOL:$<TARGET_PROPERTY:LIMNER_TESTS_ONLY>>:-Wno-stringop-overflow>)
endif()
# A multiply and an add stay two roundings unless the code asks for one: results must not depend on the compiler's mood.
target_compile_options(limner_flags INTERFACE -ffp-contract=off)
if(LIMNER_SANITIZE)
  target_compile_options(limner_flags INTERFACE -fsanitize=${LIMNER_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(limner_flags INTERFACE -fsanitize=${LIMNER_SANITIZE})
endif()

# limner_library(name): a static library of every .cpp under the calling folder, minus EXCLUDE patterns.
function(limner_library name)
  cmake_parse_arguments(ARG "" "" "EXCLUDE" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS *.cpp *.h)
  foreach(pattern IN LISTS ARG_EXCLUDE)
    list(FILTER sources EXCLUDE REGEX ${pattern})
  endforeach()
  add_library(${name} STATIC ${sources})
  target_link_libraries(${name} PUBLIC limner_flags)
  if(LIMNER_SANITIZE)
    limner_precompiled(${name}) # that each header stands alone is seen in the other builds
  endif()
endfunction()

# limner_precompiled(target headers...): these and the standard library's are parsed once for the target's sources.
function(limner_precompiled target)
  list(TRANSFORM ARGN REPLACE "(.+)" "<\\1>")
  target_precompile_headers(${target} PRIVATE <algorithm> <array> <cmath> <filesystem> <fstream> <functional> <limits>
                                              <map> <memory> <optional> <random> <set> <span> <sstream> <string>
                                              <utility> <vector> <glm/glm.hpp> ${ARGN})
  # GCC 12 forgets that std::string of a precompiled header is the system's and warns of writes that are not there.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    target_compile_options(${target} PRIVATE -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread)
  endif()
endfunction()

# limner_dispatched(files...): sources that are compiled for every instruction set (Highway's foreach_target.h).
# Highway's lowest target on plain x86-64 is scalar; SSE4 needs a file built for x86-64-v2 with AES and PCLMUL, which every
# x86 processor since 2011 has. SSSE3 and the Ice Lake target would only add code: nothing here uses what they add.
# What sanitizers look for is the same on every set: they get the lowest one, the others cost minutes a file.
function(limner_dispatched)
  set(left_out "HWY_SSSE3|HWY_AVX3_DL")
  if(LIMNER_SANITIZE)
    string(APPEND left_out "|HWY_AVX2|HWY_AVX3")
  endif()
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    set_property(SOURCE ${ARGN} APPEND PROPERTY COMPILE_OPTIONS
      "-march=x86-64-v2;-maes;-mpclmul;-DHWY_DISABLED_TARGETS=(${left_out})")
    set_property(SOURCE ${ARGN} PROPERTY SKIP_PRECOMPILE_HEADERS ON) # its flags are others
  endif()
endfunction()

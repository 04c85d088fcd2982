# Run by ctest (TEST_INCLUDE_FILES), not by the build: makes a test of every suite of a runner. A process for every
# single test would spend most of the run on starting: most of a second each, for the libraries that a runner links.
# Reads: cmake and runner (programs), label, environment, results (folder of the XML reports), properties (of every test).
execute_process(COMMAND ${cmake} -E env ${environment} ${runner} --gtest_list_tests
                OUTPUT_VARIABLE listed RESULT_VARIABLE failed ERROR_QUIET)
if(NOT failed EQUAL 0)
  add_test(${label}.list ${runner} --gtest_list_tests) # fails and says why
  return()
endif()
string(REGEX MATCHALL "(^|\n)[A-Za-z0-9_/]+\\." suites "${listed}")
foreach(suite IN LISTS suites)
  string(REGEX REPLACE "[\n.]" "" suite "${suite}")
  string(REPLACE "/" "_" file "${suite}")
  add_test(${suite} ${runner} --gtest_filter=${suite}.* --gtest_output=xml:${results}/${label}.${file}.xml)
  set_tests_properties(${suite} PROPERTIES LABELS ${label} ENVIRONMENT "${environment}" ${properties})
endforeach()

# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause

# Included by CTest each time it is started. Many cases take less time than a process takes to start
# and to make its first window, so that the cases of a suite share a process.
# Scripts/summarize_tests.py reads what they print and finds what came of each.

# nbuffer_add_cases(<program> <label> <suffix> <filter> <cases>)
#
# Adds tests for the cases of GoogleTest that the filter names, at most so many in one process. They
# are called <label>.<suite><suffix>, and from the second process of a suite on
# <label>.<suite>.<number><suffix>. Sets nbuffer_tests to their names.
function (nbuffer_add_cases program label suffix filter cases)
  if (filter STREQUAL "")
    set(filter "*")
  endif ()
  get_filename_component(name "${program}" NAME_WE)
  set(tests "${label}.${name}-is-missing${suffix}")
  if (NOT EXISTS "${program}")
    # A test whose program is missing fails.
    add_test("${tests}" "${program}")
  else ()
    set(tests)
    execute_process(COMMAND "${program}" --gtest_list_tests "--gtest_filter=${filter}"
      OUTPUT_VARIABLE lines COMMAND_ERROR_IS_FATAL ANY)
    string(REGEX MATCHALL "[^\n]+" lines "${lines}")
    set(found)
    foreach (line IN LISTS lines ITEMS "end.")
      # After the name there may be the value of its parameter.
      if (line MATCHES "^  ([^ ]+)")
        list(APPEND found "${suite}.${CMAKE_MATCH_1}")
      elseif (line MATCHES "^([^ ]+)\\.")
        set(following "${CMAKE_MATCH_1}")
        set(part 1)
        set(number)
        while (found)
          list(SUBLIST found 0 ${cases} chosen)
          list(REMOVE_ITEM found ${chosen})
          list(JOIN chosen ":" chosen)
          set(test "${label}.${suite}${number}${suffix}")
          add_test("${test}" "${program}" "--gtest_filter=${chosen}")
          list(APPEND tests "${test}")
          math(EXPR part "${part} + 1")
          set(number ".${part}")
        endwhile ()
        set(suite "${following}")
      endif ()
    endforeach ()
  endif ()
  set(nbuffer_tests "${tests}" PARENT_SCOPE)
endfunction ()

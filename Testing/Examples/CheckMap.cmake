# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause

# cmake -DPROGRAM=... -DWRITER=... -DOUT=... -P this
#
# The study of a map: its table of visibility agrees with what is seen, and a table that does not is
# found out. A map that is damaged is an error that says so.

file(REMOVE_RECURSE "${OUT}")
file(MAKE_DIRECTORY "${OUT}")

function (run_study map expected)
  execute_process(
    COMMAND "${PROGRAM}" study --tiny --frames 6 --size 161x119 --scene "${OUT}/${map}"
      --out "${OUT}/study" --json "${OUT}/study/study.json"
    OUTPUT_VARIABLE output
    ERROR_VARIABLE output
    RESULT_VARIABLE result)
  message("${output}")
  if (NOT result STREQUAL expected)
    message(FATAL_ERROR "the study of ${map} ended with ${result} instead of ${expected}")
  endif ()
  set(output "${output}" PARENT_SCOPE)
endfunction ()

execute_process(COMMAND "${WRITER}" "${OUT}/true.bsp" COMMAND_ERROR_IS_FATAL ANY)
run_study(true.bsp:faces 0)
file(READ "${OUT}/study/study.json" json)
string(JSON table GET "${json}" scenes 0 table)
string(JSON contradictions GET "${table}" contradictions)
string(JSON pixels GET "${table}" pixels)
string(JSON undrawn GET "${table}" undrawn_pixels)
if (NOT contradictions EQUAL 0 OR NOT pixels GREATER 0 OR NOT undrawn GREATER 0)
  message(FATAL_ERROR "${contradictions} contradictions, ${pixels} pixels, ${undrawn} through the wall")
endif ()
run_study(true.bsp:clusters 0)

execute_process(COMMAND "${WRITER}" "${OUT}/lie.bsp" lie COMMAND_ERROR_IS_FATAL ANY)
run_study(lie.bsp 2)
file(READ "${OUT}/study/study.json" json)
string(JSON contradictions GET "${json}" scenes 0 table contradictions)
if (NOT contradictions GREATER 0)
  message(FATAL_ERROR "a table that hides what is seen was believed")
endif ()

file(WRITE "${OUT}/cut.bsp" "IBSP.")
run_study(cut.bsp 1)
if (NOT output MATCHES "cut.bsp: damaged map: its directory ends after the file does")
  message(FATAL_ERROR "the message does not say what is wrong")
endif ()

# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause

# cmake -DPROGRAM=... -DPICTURE=... -DARGUMENTS=... -DCOMPARE=... -DBASELINES=... -DOUT=... -P this
#
# Runs a program of the examples as a user does, with and without shadows, and
# compares its picture with the baseline: that with shadows has to be like it,
# that without must not.

if (SYSTEM STREQUAL "x" AND NOT DEFINED ENV{DISPLAY})
  message("Skipped: this VTK opens X windows only, and DISPLAY is not set")
  return ()
endif ()

file(REMOVE_RECURSE "${OUT}")
foreach (option IN ITEMS "" "--no-shadows")
  execute_process(
    COMMAND "${PROGRAM}" --out "${OUT}${option}" --size 320x240 ${ARGUMENTS} ${option}
    OUTPUT_VARIABLE output
    ERROR_VARIABLE errors
    RESULT_VARIABLE result)
  message("${output}${errors}")
  if (NOT result STREQUAL 0 OR NOT errors STREQUAL "")
    message(FATAL_ERROR "${PROGRAM} ${option} ended with ${result}")
  endif ()
endforeach ()
execute_process(
  COMMAND "${COMPARE}" "${BASELINES}/${PICTURE}.png" "${OUT}/${PICTURE}.png"
    "${OUT}--no-shadows/${PICTURE}.png"
  RESULT_VARIABLE result)
if (NOT result STREQUAL 0)
  message(FATAL_ERROR "The pictures are not what they have to be; ${BASELINES}/README.md says more")
endif ()

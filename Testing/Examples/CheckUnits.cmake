# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause

# cmake -DPROGRAM=... -DPICTURE=... -DOUT=... -DSYSTEM=... -P this
#
# Runs an example of one large prop: units of it are hidden in every frame, no byte of the image
# differs, and there is a picture, which is the same without the culler.

if (SYSTEM STREQUAL "x" AND NOT DEFINED ENV{DISPLAY})
  message("Skipped: this VTK opens X windows only, and DISPLAY is not set")
  return ()
endif ()

file(REMOVE_RECURSE "${OUT}" "${OUT}--no-culler")
foreach (option IN ITEMS "" "--no-culler")
  execute_process(
    COMMAND "${PROGRAM}" --out "${OUT}${option}" --size 320x240 --frames 3 ${option}
    OUTPUT_VARIABLE output
    ERROR_VARIABLE errors
    RESULT_VARIABLE result)
  message("${output}${errors}")
  string(REGEX MATCHALL "units drawn, [1-9][0-9]* hidden" hidden "${output}")
  list(LENGTH hidden frames)
  if (option STREQUAL "" AND NOT frames EQUAL 3)
    message(FATAL_ERROR "units are hidden in ${frames} of 3 frames")
  endif ()
  if (NOT result STREQUAL 0 OR NOT errors STREQUAL "" OR NOT output MATCHES "; 0 bytes differ\n")
    message(FATAL_ERROR "${PROGRAM} ${option} ended with ${result}")
  endif ()
  file(SHA256 "${OUT}${option}/${PICTURE}.png" sum)
  list(APPEND pictures "${sum}")
endforeach ()
list(REMOVE_DUPLICATES pictures)
list(LENGTH pictures different)
if (NOT different EQUAL 1)
  message(FATAL_ERROR "the culler changes the picture")
endif ()

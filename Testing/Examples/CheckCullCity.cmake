# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause

# cmake -DPROGRAM=... -DOUT=... -DSYSTEM=... -P this
#
# Draws the city with and without the culler: the pictures must be the same and the culler must have
# left props out.

if (SYSTEM STREQUAL "x" AND NOT DEFINED ENV{DISPLAY})
  message("Skipped: this VTK opens X windows only, and DISPLAY is not set")
  return ()
endif ()

file(REMOVE_RECURSE "${OUT}")
foreach (option IN ITEMS "" "--no-culler")
  execute_process(
    COMMAND "${PROGRAM}" --out "${OUT}${option}" --size 320x240 ${option}
    OUTPUT_VARIABLE output
    ERROR_VARIABLE errors
    RESULT_VARIABLE result)
  message("${output}${errors}")
  if (NOT result STREQUAL 0 OR NOT errors STREQUAL "")
    message(FATAL_ERROR "cull-city ${option} ended with ${result}")
  endif ()
  string(REGEX MATCH "([0-9]+) of 15860 props drawn, ([0-9]+) found hidden" match "${output}")
  list(APPEND drawn "${CMAKE_MATCH_1}")
  list(APPEND hidden "${CMAKE_MATCH_2}")
endforeach ()
list(GET drawn 0 with)
list(GET drawn 1 without)
list(GET hidden 0 found)
if (NOT with LESS without OR NOT found GREATER 0)
  message(FATAL_ERROR "${with} props drawn with the culler, ${without} without it, ${found} hidden")
endif ()
file(SHA256 "${OUT}/cull-city.png" picture)
file(SHA256 "${OUT}--no-culler/cull-city.png" expected)
if (NOT picture STREQUAL expected)
  message(FATAL_ERROR "the culler changes the picture")
endif ()

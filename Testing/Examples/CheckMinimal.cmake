# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause

# cmake -DPROGRAM=... -DSYSTEM=... -P this
#
# Runs the first example: some cones are drawn, and most are hidden.

if (SYSTEM STREQUAL "x" AND NOT DEFINED ENV{DISPLAY})
  message("Skipped: this VTK opens X windows only, and DISPLAY is not set")
  return ()
endif ()

execute_process(
  COMMAND "${PROGRAM}"
  OUTPUT_VARIABLE output
  ERROR_VARIABLE errors
  RESULT_VARIABLE result)
message("${output}${errors}")
if (NOT result STREQUAL 0 OR NOT errors STREQUAL ""
    OR NOT output MATCHES "^[1-9][0-9]* of 10000 cones drawn, [1-9][0-9]* hidden\n$")
  message(FATAL_ERROR "ended with ${result}")
endif ()

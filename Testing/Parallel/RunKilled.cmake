# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause

# Run by CTest with -D: mpiexec, program. One process is killed in frame 4. MPI must say so and end
# the others with an error; a time-out is a failure.
execute_process(COMMAND "${mpiexec}" -n 3 "${program}" --case killed --thinned 8 --frames 12 --width 320 --height 240
  TIMEOUT 150 RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
message("${output}")
if (output MATCHES "SKIPPED: ")
  return()
endif ()
if (result EQUAL 0 OR result MATCHES "timeout")
  message(FATAL_ERROR "the result is ${result}")
endif ()
if (NOT output MATCHES "frame 3 is drawn" OR output MATCHES "frame 4 is drawn")
  message(FATAL_ERROR "the process was not killed in frame 4")
endif ()
# Open MPI; MPICH.
if (NOT output MATCHES "exited on signal 9" AND NOT output MATCHES "EXIT CODE: 9")
  message(FATAL_ERROR "MPI does not say that a process was killed")
endif ()

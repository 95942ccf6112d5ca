# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause

# cmake -DPROGRAM=nbuffer-bench -DOUT=maps.json -P this
#
# Settings of VTK's shadow maps do what they are for: a small exponent loses shadows, a polygon offset
# takes acne away, and a map that is drawn for each frame is the same map. Without a setting for the
# exponent (VTK 9.1) only the last one is tested, and that an offset changes something.

execute_process(
  COMMAND "${PROGRAM}" defaults OUTPUT_VARIABLE defaults COMMAND_ERROR_IS_FATAL ANY)
string(JSON exponent ERROR_VARIABLE no_exponent GET "${defaults}" maps Exponent)
set(plain vtk@256)
set(small vtk@256:Exponent=2)
set(large vtk@256:Exponent=80)
set(offset vtk@256:Exponent=80:OffsetFactor=4)
if (no_exponent)
  set(small ${plain})
  set(large ${plain})
  set(offset vtk@256:OffsetFactor=4)
endif ()
set(again vtk@256:EachFrame=1)
execute_process(
  COMMAND "${PROGRAM}" shadow --scene birds --size 161x161 --frames 2 --oracle --oracle-once
    --modes "none,${plain},${small},${large},${offset},${again}" --json "${OUT}"
  COMMAND_ERROR_IS_FATAL ANY)
file(READ "${OUT}" json)
foreach (mode IN ITEMS plain small large offset again)
  string(JSON errors GET "${json}" modes ${${mode}} oracle errors)
  string(JSON wrong GET "${json}" modes ${${mode}} oracle wrong)
  foreach (error IN ITEMS outline acne peter_panning leak)
    string(JSON ${error} GET "${errors}" ${error})
  endforeach ()
  math(EXPR sum "${outline} + ${acne} + ${peter_panning} + ${leak}")
  math(EXPR ${mode}_lost "${peter_panning} + ${leak}")
  set(${mode}_acne ${acne})
  set(${mode}_errors "${errors}")
  if (NOT sum EQUAL wrong)
    message(FATAL_ERROR "${${mode}}: ${wrong} wrong samples, and ${errors}")
  endif ()
endforeach ()
if ((NOT no_exponent AND NOT (small_lost GREATER plain_lost AND offset_acne LESS large_acne))
    OR offset_errors STREQUAL large_errors OR NOT again_errors STREQUAL plain_errors)
  message(FATAL_ERROR "${plain_errors}, exponent 2 ${small_errors}, 80 ${large_errors}, with an offset "
    "${offset_errors}, for each frame ${again_errors}")
endif ()

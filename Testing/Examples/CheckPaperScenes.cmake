# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause

# cmake -DPROGRAM=nbuffer-bench -DOUT=walk.json -P this
#
# What section 3.1 of the N-buffer paper says: a sphere in a slightly larger one is not found by its
# box (but by its triangles), and what small leaves hide together is found by either.

# SCENE,most that may be drawn by boxes,and by triangles,fewest that may be drawn by boxes
foreach (limit IN ITEMS shells,128,66,128 leaves,96,96,0)
  string(REPLACE "," ";" limit "${limit}")
  list(GET limit 0 scene)
  execute_process(
    COMMAND "${PROGRAM}" walk --scene ${scene} --frames 4 --warm-up 2 --size 320x240
      --modes nbuffer:TestPixels=0:TestTriangles=0:BackOff=0,nbuffer:BackOff=0 --json "${OUT}"
    COMMAND_ERROR_IS_FATAL ANY)
  file(READ "${OUT}" json)
  string(JSON boxes GET "${json}" modes nbuffer:TestPixels=0:TestTriangles=0:BackOff=0
    frames_drawn 3)
  string(JSON triangles GET "${json}" modes nbuffer:BackOff=0 frames_drawn 3)
  message("${scene}: ${boxes} drawn by boxes, ${triangles} by triangles")
  list(GET limit 1 most_boxes)
  list(GET limit 2 most_triangles)
  list(GET limit 3 fewest)
  if (boxes GREATER most_boxes OR triangles GREATER most_triangles OR boxes LESS fewest)
    message(FATAL_ERROR "${scene}: the paper, or the documents, say otherwise")
  endif ()
endforeach ()

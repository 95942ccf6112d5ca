# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause

# cmake -DPROGRAM=nbuffer-bench -DOUT=walk.json -P this
#
# How many of the hidden props of the city are drawn all the same. These are counts of props, which do
# not vary with the load of the machine; the culler's setting that measures time is off. Props that
# are drawn for the sake of slivers count, except where it says TestSlivers=0.

# PATH,largest number of props for each 10,000 that are hidden,settings
foreach (limit IN ITEMS street,10,BackOff=0:TestSlivers=0 street,16,BackOff=0 rooftop,200,BackOff=0)
  string(REPLACE "," ";" limit "${limit}")
  list(GET limit 0 path)
  list(GET limit 1 most)
  list(GET limit 2 settings)
  execute_process(
    COMMAND "${PROGRAM}" walk --path ${path} --frames 3 --size 480x360
      --modes in-view,nbuffer:${settings},oracle --json "${OUT}"
    COMMAND_ERROR_IS_FATAL ANY)
  file(READ "${OUT}" json)
  set(in_view 0)
  set(drawn 0)
  set(seen 0)
  foreach (frame RANGE 2)
    string(JSON a GET "${json}" modes in-view frames_drawn ${frame})
    string(JSON b GET "${json}" modes nbuffer:${settings} frames_drawn ${frame})
    string(JSON c GET "${json}" modes oracle frames_drawn ${frame})
    math(EXPR in_view "${in_view} + ${a}")
    math(EXPR drawn "${drawn} + ${b}")
    math(EXPR seen "${seen} + ${c}")
  endforeach ()
  math(EXPR hidden "${in_view} - ${seen}")
  math(EXPR kept "${drawn} - ${seen}")
  math(EXPR share "10000 * ${kept} / ${hidden}")
  message("${path}, ${settings}: ${kept} of ${hidden} hidden props drawn, ${share} of 10,000")
  if (kept LESS 0 OR hidden LESS 5000 OR share GREATER most)
    message(FATAL_ERROR "${path}: at most ${most} of 10,000 hidden props may be drawn")
  endif ()
endforeach ()

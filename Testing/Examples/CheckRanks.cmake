# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause

# cmake -DPROGRAM=nbuffer-bench -DOUT=ranks.json -P this
#
# What 1, 16 and 1,000 simulated ranks draw of the city in the street. The picture is small, and so
# are its tiles.

execute_process(
  COMMAND "${PROGRAM}" ranks --ranks 1,16,1000 --size 161x119 --tile 2 --json "${OUT}"
  COMMAND_ERROR_IS_FATAL ANY)
file(READ "${OUT}" json)
string(JSON oracle GET "${json}" own_a_pixel)
foreach (ranks IN ITEMS 1 16 1000)
  # Without one of these keys there is an error.
  foreach (key IN ITEMS drawn_local drawn_shared busiest idle bytes visible_hidden)
    string(JSON ${key} GET "${json}" ranks ${ranks} ${key})
  endforeach ()
  set(drawn_${ranks} ${drawn_shared})
  # A message has 4 bytes for each of 81 x 60 tiles, 12 for each rank, and 176 more.
  math(EXPR expected "4 * 81 * 60 + 12 * ${ranks} + 176")
  if (ranks EQUAL 1)
    set(expected 0)
  endif ()
  if (NOT visible_hidden EQUAL 0 OR NOT bytes EQUAL expected OR busiest GREATER drawn_shared
      OR drawn_shared GREATER drawn_local OR NOT idle LESS ranks)
    message(FATAL_ERROR "${ranks} ranks: ${visible_hidden} visible props hidden, ${bytes} bytes "
      "instead of ${expected}, ${busiest} of ${drawn_shared} props drawn by one rank, "
      "${drawn_local} with its own depth, ${idle} ranks draw none")
  endif ()
endforeach ()
math(EXPR most_1000 "13 * ${oracle} / 10")
math(EXPR most_16 "15 * ${drawn_1} / 10")
if (oracle LESS 10 OR drawn_1000 GREATER most_1000 OR drawn_16 GREATER most_16)
  message(FATAL_ERROR "${oracle} props own a pixel; one rank draws ${drawn_1}, 16 draw ${drawn_16} "
    "and 1,000 draw ${drawn_1000}")
endif ()

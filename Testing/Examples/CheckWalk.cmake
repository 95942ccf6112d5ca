# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause

# cmake -DPROGRAM=nbuffer-bench -DOUT=walk.json -P this
#
# How many frames of a walk are not timed, with and without --warm-up, and how many props are in view
# of the path aside.

function (walk)
  execute_process(
    COMMAND "${PROGRAM}" walk --scene ${scene} --size 161x119 --verify --json "${OUT}" ${ARGN}
    COMMAND_ERROR_IS_FATAL ANY)
  file(READ "${OUT}" json)
  set(json "${json}" PARENT_SCOPE)
endfunction ()

set(scene plant)

# One frame to begin with and one before each of the two blocks; then seven, which go forth and back
# along the path of three frames.
foreach (case IN ITEMS "3" "9;--warm-up;7")
  list(POP_FRONT case expected)
  walk(--path inside --frames 3 --block 2 --modes stock,nbuffer,none ${case})
  foreach (mode IN ITEMS stock nbuffer none)
    string(JSON untimed GET "${json}" modes ${mode} untimed_frames)
    string(JSON timed LENGTH "${json}" modes ${mode} frames_ms)
    if (NOT untimed EQUAL expected OR NOT timed EQUAL 3)
      message(FATAL_ERROR "${mode}: ${untimed} frames untimed instead of ${expected}, ${timed} timed")
    endif ()
  endforeach ()
endforeach ()

walk(--path aside --props 10000 --frames 4 --modes stock,nbuffer,in-view,oracle,none)
string(JSON props GET "${json}" props)
foreach (frame RANGE 3)
  foreach (mode IN ITEMS stock nbuffer in-view oracle)
    string(JSON ${mode} GET "${json}" modes ${mode} frames_drawn ${frame})
  endforeach ()
  # The default culler tests bounding spheres, which are in view where boxes are not.
  if (nbuffer LESS 1 OR nbuffer GREATER 5 OR stock GREATER 100 OR NOT in-view EQUAL stock
      OR oracle GREATER nbuffer OR NOT props EQUAL 10000)
    message(FATAL_ERROR "frame ${frame}: of ${props} props stock draws ${stock}, nbuffer ${nbuffer}, "
      "in-view ${in-view}, oracle ${oracle}")
  endif ()
endforeach ()

# Depth first: what stock draws is drawn once for its depth, and with colours about once for each pixel
# that shows a prop; the culler culls in this pass, too.
set(scene city) # Props of the plant share mappers.
walk(--path street --frames 3 --fragments 1
  --modes stock,nbuffer,early-depth,early-depth-nbuffer,none)
foreach (mode IN ITEMS stock nbuffer)
  string(REPLACE stock early-depth early ${mode})
  string(REPLACE nbuffer early-depth-nbuffer early ${early})
  string(JSON plain GET "${json}" fragments ${mode} passed)
  string(JSON depth GET "${json}" fragments ${early} of_depth)
  string(JSON colors GET "${json}" fragments ${early} passed)
  string(JSON shown GET "${json}" fragments ${early} shown)
  # Equal depths alone are drawn with colours more than once.
  string(REGEX REPLACE "[.].*" "" pixels ${shown})
  math(EXPR most "${pixels} + ${pixels} / 100 + 1")
  if (colors LESS shown OR colors GREATER most OR plain LESS_EQUAL colors OR depth LESS colors)
    message(FATAL_ERROR "${early}: ${depth} fragments for depth, ${colors} with colours of "
      "${shown} pixels, ${plain} in mode ${mode}")
  endif ()
endforeach ()
string(JSON stock GET "${json}" fragments stock passed)
string(JSON depth GET "${json}" fragments early-depth of_depth)
string(JSON culled GET "${json}" modes early-depth-nbuffer drawn)
string(JSON all GET "${json}" modes early-depth drawn)
string(JSON expected GET "${json}" modes stock drawn)
if (NOT depth EQUAL stock OR NOT all EQUAL expected OR NOT culled LESS all)
  message(FATAL_ERROR "${depth} fragments for depth instead of ${stock}; ${all} props drawn instead "
    "of ${expected}, with the culler ${culled}")
endif ()

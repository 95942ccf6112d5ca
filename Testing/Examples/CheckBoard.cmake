# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause

# cmake -DPROGRAM=... -DOUT=... -P this
#
# A board and a cage of boards with two parts of one model, written here; one part without a model.

file(REMOVE_RECURSE "${OUT}")
file(WRITE "${OUT}/kicad-3dmodels/T.3dshapes/T.wrl" "#VRML V2.0 utf8
Shape { appearance Appearance { material Material { diffuseColor 0.9 0.5 0.2 } }
  geometry IndexedFaceSet { coord Coordinate { point [ 0 0 0, 1 0 0, 0 1 0, 0 0 1 ] }
    coordIndex [ 0,2,1,-1, 0,1,3,-1, 0,3,2,-1, 1,2,3,-1 ] } }
Shape { appearance Appearance { material Material { diffuseColor 0.2 0.5 0.9 } }
  geometry IndexedFaceSet { coord Coordinate { point [ 2 0 0, 3 0 0, 2 1 0, 2 0 1 ] }
    coordIndex [ 0,2,1,-1, 0,1,3,-1, 0,3,2,-1, 1,2,3,-1 ] } }
")
set(model "(model \"\${KICAD6_3DMODEL_DIR}/T.3dshapes/T.wrl\" (offset (xyz 0 0 0)) (scale (xyz 1 1 1)) (rotate (xyz 0 0 0)))")
file(WRITE "${OUT}/board.kicad_pcb" "(kicad_pcb (version 20211014) (general (thickness 1.6))
  (footprint \"T\" (layer \"F.Cu\") (at 10 10 90) ${model})
  (footprint \"T\" (layer \"B.Cu\") (at 30 20) ${model})
  (footprint \"N\" (layer \"F.Cu\") (at 30 20) (model \"\${KICAD6_3DMODEL_DIR}/no.wrl\"))
  (gr_line (start 0 0) (end 50 40) (layer \"Edge.Cuts\")))
")

# Of a board two shapes of two parts and itself; of a cage two parts, or their shapes, and the board,
# 80 times.
foreach (case IN ITEMS "board.kicad_pcb|over|5" ".|outside|240" ".|between|240" ".:actors|outside|400")
  string(REPLACE "|" ";" case "${case}")
  list(GET case 0 name)
  list(GET case 1 path)
  list(GET case 2 props)
  execute_process(
    COMMAND "${PROGRAM}" walk --scene "${OUT}/${name}" --path ${path} --frames 3 --size 161x119
      --verify --json "${OUT}/walk.json"
    OUTPUT_VARIABLE output
    ERROR_VARIABLE output
    RESULT_VARIABLE result)
  message("${output}")
  if (NOT result STREQUAL 0)
    message(FATAL_ERROR "${name}, ${path}: ended with ${result}")
  endif ()
  file(READ "${OUT}/walk.json" json)
  string(JSON count GET "${json}" props)
  if (NOT count EQUAL props)
    message(FATAL_ERROR "${name}: ${count} props instead of ${props}")
  endif ()
endforeach ()

file(REMOVE_RECURSE "${OUT}/kicad-3dmodels")
execute_process(
  COMMAND "${CMAKE_COMMAND}" -E env --unset=KICAD6_3DMODEL_DIR
    "${PROGRAM}" walk --scene "${OUT}/board.kicad_pcb" --frames 1
  ERROR_VARIABLE output
  RESULT_VARIABLE result)
if (NOT result STREQUAL 1 OR NOT output MATCHES "none of the models of its parts was found")
  message(FATAL_ERROR "without models: ${result}, ${output}")
endif ()

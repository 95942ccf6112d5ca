# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause

# Counts the fragments of shadow volumes in a scene of the benchmark as docs/benchmarks.md does, and
# fails if the mode exact has more of them than AIM, in % of those of whole volumes, or fewer than
# pixels that shadows change.
#   cmake -DPROGRAM=nbuffer-bench -DSCENE=... -DAIM=... -DOUT=file.json -P CheckShadowAim.cmake

execute_process(COMMAND "${PROGRAM}" shadow --scene ${SCENE} --frames 16 --block 2
  --modes unclamped,exact --json "${OUT}" COMMAND_ERROR_IS_FATAL ANY)
file(READ "${OUT}" json)
string(JSON percent GET "${json}" modes exact fragments_percent)
string(JSON fragments GET "${json}" modes exact fragments)
string(JSON shadowed GET "${json}" shadowed)
if (NOT percent LESS_EQUAL AIM)
  message(FATAL_ERROR "exact has ${percent} % of the fragments; ${AIM} % are allowed")
endif ()
if (shadowed EQUAL 0 OR fragments LESS shadowed)
  message(FATAL_ERROR "${fragments} fragments for ${shadowed} pixels that shadows change")
endif ()

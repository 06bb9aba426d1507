# SPDX-License-Identifier: GPL-3.0-or-later
"""The names of stages in progress reports, in order; each has an equal share of the progress."""

VALIDATING = "validating"
FINDING = "finding self-intersections"
ORIENTING = "orienting"
RESOLVING = "resolving self-intersections"
TETRAHEDRALIZING = "tetrahedralizing"
WINDING_NUMBERS = "winding numbers"
DISTANCES = "distances"
SEGMENTING = "segmenting"
EXTRACTING = "extracting"
REFINING = "refining"
LAYERING = "making layers"

RESOLVE = (VALIDATING, FINDING, RESOLVING)
TETRAHEDRALIZE = (VALIDATING, FINDING, ORIENTING, RESOLVING, TETRAHEDRALIZING, WINDING_NUMBERS, SEGMENTING, EXTRACTING)
REFINE = (REFINING,)
LAYERS = (LAYERING,)
CHECK = (VALIDATING, ORIENTING, FINDING, RESOLVING, WINDING_NUMBERS, "tracing intersections")
CHECK_SOLID = (VALIDATING, FINDING, "measuring quality")
WINDING = (VALIDATING, ORIENTING, WINDING_NUMBERS)

UNNAMED = "working"
"""The stage that VTK reports at the very start and end."""

READING, WRITING, DRAWING = "reading", "writing", "drawing"
"""The stages of the command alone."""

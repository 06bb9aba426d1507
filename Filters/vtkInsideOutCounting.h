// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file Options of the classes that count facets, declared and described once. A class uses the
 * macros in its declaration, after `public:`. Each declares setters, getters and the field with its
 * default. They take no semicolon: -Wpedantic refuses it.
 */
#ifndef vtkInsideOutCounting_h
#define vtkInsideOutCounting_h

#include "vtkInsideOutRange.h" // for setters with a range
#include "vtkSetGet.h"

#include <string>

/**
 * Orientation: the facets to turn over, in a plane the outlines. AUTOMATIC makes neighboring facets
 * agree and turns inverted parts over, with a warning; cavities stay. AS_GIVEN turns nothing,
 * REVERSE everything, OUTWARD every closed part that faces inward. Default AUTOMATIC. AUTOMATIC
 * minimizes the volume where w is below -1/2; an open sheet turns nothing else over. OUTWARD turns
 * cavities, too.
 */
#define vtkInsideOutOrientationMacro()                             \
  enum OrientationType                                             \
  {                                                                \
    AUTOMATIC = 0,                                                 \
    AS_GIVEN = 1,                                                  \
    REVERSE = 2,                                                   \
    OUTWARD = 3                                                    \
  };                                                               \
  vtkInsideOutSetRangeMacro(Orientation, int, AUTOMATIC, OUTWARD); \
  vtkGetMacro(Orientation, int);                                   \
                                                                   \
protected:                                                         \
  int Orientation = AUTOMATIC;                                     \
                                                                   \
public:

/**
 * MergeTolerance: merge points at most this far apart, in units of the input, and close narrower
 * gaps between bodies. Default 0: only points with equal coordinates. Range 0 to infinity. Merged
 * points have the coordinates of the lowest id.
 */
#define vtkInsideOutMergeToleranceMacro()                                 \
  vtkInsideOutSetRangeMacro(MergeTolerance, double, 0.0, VTK_DOUBLE_MAX); \
  vtkGetMacro(MergeTolerance, double);                                    \
                                                                          \
protected:                                                                \
  double MergeTolerance = 0.0;                                            \
                                                                          \
public:

/**
 * TouchTolerance: distance between faces of two bodies up to which they touch, in units of the
 * input. They become one interface: points of the later body move onto the earlier one, and are
 * counted. 0: only faces that touch exactly. Default -1: the rounding error of the coordinates, if
 * those of both bodies are floats or decimals of up to 9 digits. Range -1 to infinity. Points of a
 * single body never move. A warning names the bodies, the distance and the number of points; the
 * statistics TouchingPairs and TouchMovedPoints count pairs of bodies and moved points.
 */
#define vtkInsideOutTouchToleranceMacro()                                  \
  vtkInsideOutSetRangeMacro(TouchTolerance, double, -1.0, VTK_DOUBLE_MAX); \
  vtkGetMacro(TouchTolerance, double);                                     \
                                                                           \
protected:                                                                 \
  double TouchTolerance = -1.0;                                            \
                                                                           \
public:

/** CountDuplicates: count every copy of a polygon, in a plane of a segment. Default off: copies
 * count as often as closed shells need them, else once. Copies of opposite orientation cancel,
 * unless one of them alone closes the surface. */
#define vtkInsideOutCountDuplicatesMacro() \
  vtkSetMacro(CountDuplicates, bool);      \
  vtkGetMacro(CountDuplicates, bool);      \
  vtkBooleanMacro(CountDuplicates, bool);  \
                                           \
protected:                                 \
  bool CountDuplicates = false;            \
                                           \
public:

/**
 * NonParticipatingArrayName: cell array of the input, one number per cell: cells where it is not 0
 * do not count in w, but still shape the mesh. Default empty: every cell counts. Such cells cancel
 * no other cell. An example are accessories that are no part of a body.
 */
#define vtkInsideOutNonParticipatingMacro()                \
  vtkSetStdStringFromCharMacro(NonParticipatingArrayName); \
  vtkGetCharFromStdStringMacro(NonParticipatingArrayName); \
                                                           \
protected:                                                 \
  std::string NonParticipatingArrayName;                   \
                                                           \
public:

#endif

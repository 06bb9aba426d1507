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
 * Orientation: how facets are turned before they count, in a plane outlines. AUTOMATIC makes
 * neighboring facets agree and turns over parts that are inside out, with a warning; cavities stay.
 * AS_GIVEN turns nothing, REVERSE everything, OUTWARD every closed part outward. Default AUTOMATIC.
 * AUTOMATIC leaves the least volume where w is below -1/2; an open sheet turns nothing else over.
 * OUTWARD ignores which part lies within which.
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
 * MergeTolerance: merge points at most this far apart, in units of the input. Narrower gaps between
 * bodies close. Default 0: only points with equal coordinates. Range 0 to infinity. The point with
 * the lowest id stays.
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
 * TouchTolerance: how far faces of two bodies may be apart that touch, in units of the input. They
 * become one interface: points of the later body move onto the earlier one, and are counted. 0:
 * only faces that touch exactly. Default -1: as far as rounding can part them, where all
 * coordinates of both bodies are floats or decimals of up to 9 digits. Range -1 to infinity. No
 * point of a single body moves. A warning names the bodies, the distance and the number of points;
 * the statistics TouchingPairs and TouchMovedPoints count the pairs of bodies and all points.
 */
#define vtkInsideOutTouchToleranceMacro()                                  \
  vtkInsideOutSetRangeMacro(TouchTolerance, double, -1.0, VTK_DOUBLE_MAX); \
  vtkGetMacro(TouchTolerance, double);                                     \
                                                                           \
protected:                                                                 \
  double TouchTolerance = -1.0;                                            \
                                                                           \
public:

/** CountDuplicates: count a polygon as often as it is given, in a plane a segment. Default off:
 * copies count as often as closed shells need them, else once. Opposite ones cancel, unless one of
 * them alone closes the surface. */
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
 * NonParticipatingArrayName: cell array of the input whose cells do not count in w where it is not
 * 0, one number per cell. They still shape the mesh. Default empty: every cell counts. Such cells
 * cancel no other. Accessories that are no part of the body are examples.
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

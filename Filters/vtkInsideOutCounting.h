// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * Options of the classes that count facets, declared and described once. A class names the macros
 * in its declaration, after `public:`. Each declares setters, getters and the field with its
 * default. No semicolon stands behind them: -Wpedantic refuses it.
 */
#ifndef vtkInsideOutCounting_h
#define vtkInsideOutCounting_h

#include "vtkSetGet.h"
#include "vtkType.h" // for VTK_DOUBLE_MAX

#include <string>

/**
 * Orientation: which way facets, or in a plane outlines, are meant to face. AUTOMATIC (0) makes
 * facets agree with those around them, and turns parts over so that the least volume is left where
 * w is below -1/2, with a warning: a cavity stays, and an open sheet turns nothing else over.
 * AS_GIVEN (1) turns nothing, REVERSE (2) everything. OUTWARD (3) makes every part that encloses
 * something face outward, whatever lies within what. Default AUTOMATIC.
 */
#define vtkInsideOutOrientationMacro()                    \
  enum OrientationType                                    \
  {                                                       \
    AUTOMATIC = 0,                                        \
    AS_GIVEN = 1,                                         \
    REVERSE = 2,                                          \
    OUTWARD = 3                                           \
  };                                                      \
  vtkSetClampMacro(Orientation, int, AUTOMATIC, OUTWARD); \
  vtkGetMacro(Orientation, int);                          \
                                                          \
protected:                                                \
  int Orientation = AUTOMATIC;                            \
                                                          \
public:

/**
 * MergeTolerance: points at most this far apart become one, in units of the input; of several the
 * one with the lowest id stays. Default 0: only points with equal coordinates are merged. Range 0
 * to infinity.
 */
#define vtkInsideOutMergeToleranceMacro()                        \
  vtkSetClampMacro(MergeTolerance, double, 0.0, VTK_DOUBLE_MAX); \
  vtkGetMacro(MergeTolerance, double);                           \
                                                                 \
protected:                                                       \
  double MergeTolerance = 0.0;                                   \
                                                                 \
public:

/**
 * CountDuplicates: count a polygon, or in a plane a segment, as often as it is given. Default off:
 * copies with the same points count once per orientation, and opposite ones cancel.
 */
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
 * NonParticipatingArrayName: name of a cell array of the input, of one number per cell. Where it is
 * not 0 the cell does not count in w and cancels no other; where a mesh is made it still shapes
 * that, as accessories that are no part of the body should. Default empty: every cell counts.
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

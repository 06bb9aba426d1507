// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file Options of the classes that make tetrahedra, declared and described once. A class uses the
 * macros in its declaration, after `public:`, and sets the fields' defaults. They take no
 * semicolon: -Wpedantic refuses it.
 */
#ifndef vtkInsideOutEngine_h
#define vtkInsideOutEngine_h

#include "vtkInsideOutRange.h" // for setters with a range
#include "vtkSetGet.h"

/**
 * Engine: program that makes the tetrahedra. ENGINE_EXACT flips and cuts with exact predicates, in
 * this process; ENGINE_TETGEN runs TetGen; ENGINE_AUTOMATIC runs TetGen only where the exact engine
 * loses a facet. Default ENGINE_AUTOMATIC. If no mesh keeps all facets, the one that loses the
 * fewest is taken.
 */
#define vtkInsideOutEngineMacro()                                          \
  enum EngineType                                                          \
  {                                                                        \
    ENGINE_AUTOMATIC = 0,                                                  \
    ENGINE_EXACT = 1,                                                      \
    ENGINE_TETGEN = 2                                                      \
  };                                                                       \
  vtkInsideOutSetRangeMacro(Engine, int, ENGINE_AUTOMATIC, ENGINE_TETGEN); \
  vtkGetMacro(Engine, int);                                                \
  void SetEngineToAutomatic()                                              \
  {                                                                        \
    this->SetEngine(ENGINE_AUTOMATIC);                                     \
  }                                                                        \
  void SetEngineToExact()                                                  \
  {                                                                        \
    this->SetEngine(ENGINE_EXACT);                                         \
  }                                                                        \
  void SetEngineToTetGen()                                                 \
  {                                                                        \
    this->SetEngine(ENGINE_TETGEN);                                        \
  }                                                                        \
                                                                           \
protected:                                                                 \
  int Engine;                                                              \
                                                                           \
public:

/**
 * TimeBudget: limit on the seconds of tetrahedralizing, in all attempts together. Default 0:
 * limited by work, not by the clock, so that a busy machine gives the same mesh. Range 0 to
 * infinity. Each kind of attempt gets an equal share. With 0 each of TetGen's attempts is limited
 * to 4 s of processor time plus 0.3 ms per point and facet.
 */
#define vtkInsideOutTimeBudgetMacro()                                 \
  vtkInsideOutSetRangeMacro(TimeBudget, double, 0.0, VTK_DOUBLE_MAX); \
  vtkGetMacro(TimeBudget, double);                                    \
                                                                      \
protected:                                                            \
  double TimeBudget;                                                  \
                                                                      \
public:

/**
 * MemoryBudget: limit on the memory of TetGen's process, in MiB. Default 0: a limit by the size of
 * the surface. Range 0 to infinity. An attempt that exceeds it is followed by the next one. With 0
 * the limit is 1024 MiB plus 16 KiB per point and facet, but at most three quarters of the
 * machine's memory.
 */
#define vtkInsideOutMemoryBudgetMacro()                                 \
  vtkInsideOutSetRangeMacro(MemoryBudget, double, 0.0, VTK_DOUBLE_MAX); \
  vtkGetMacro(MemoryBudget, double);                                    \
                                                                        \
protected:                                                              \
  double MemoryBudget;                                                  \
                                                                        \
public:

#endif

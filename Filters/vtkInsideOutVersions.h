// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * The differences between versions of VTK that matter to this module. Each names the release notes
 * and their section.
 */
#ifndef vtkInsideOutVersions_h
#define vtkInsideOutVersions_h

// For VTK_MINOR_VERSION. Without vtkVersionMacros.h included first, the other headers of 9.7 warn.
#include "vtkDeprecation.h"
#include "vtkType.h" // for the ABI namespace

#include <string>

// 9.3, New Features, "ABI Namespace": an inline namespace around VTK's classes, unnamed by default.
#ifndef VTK_ABI_NAMESPACE_BEGIN
#define VTK_ABI_NAMESPACE_BEGIN
#define VTK_ABI_NAMESPACE_END
#endif

/**
 * Declares WriteFile(), with which a subclass of vtkWriter writes, and arranges its call. It
 * reports errors by SetErrorCode(): then Write() returns 0. 9.7, I/O, "vtkWriter::Write() now
 * return the correct value": the function to override is WriteDataAndReturn(), and WriteData()
 * alone is an error. It returns true here: otherwise an error without a reason would follow the
 * actual one.
 */
#if VTK_MAJOR_VERSION > 9 || VTK_MINOR_VERSION >= 7
#define vtkInsideOutWriteMacro()     \
  bool WriteDataAndReturn() override \
  {                                  \
    this->WriteFile();               \
    return true;                     \
  }                                  \
  void WriteFile()
#else
#define vtkInsideOutWriteMacro() \
  void WriteData() override      \
  {                              \
    this->WriteFile();           \
  }                              \
  void WriteFile()
#endif

#ifndef __VTK_WRAP__
namespace vtkInsideOut
{
///@{
/** The name of an object. 9.2, Core: "vtkObject instances may now be assigned a name used in
 * reporting". Older versions have none. */
template <typename Object>
auto NameOf(Object* object, int) -> decltype(object->GetObjectName())
{
  return object->GetObjectName();
}
template <typename Object>
std::string NameOf(Object*, long)
{
  return "";
}
///@}

///@{
/** Whether an algorithm should stop. 9.3, Filters: "CheckAbort" asks every algorithm upstream, too;
 * so does the 9.2 of ParaView 5.11. Older versions have only the algorithm's own flag. */
template <typename Algorithm>
auto IsAborted(Algorithm* algorithm, int) -> decltype(algorithm->CheckAbort(), bool())
{
  return algorithm->CheckAbort();
}
template <typename Algorithm>
bool IsAborted(Algorithm* algorithm, long)
{
  return algorithm->GetAbortExecute() != 0;
}
///@}
} // namespace vtkInsideOut
#endif

#endif

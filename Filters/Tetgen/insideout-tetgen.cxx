// SPDX-License-Identifier: AGPL-3.0-or-later
//
// insideout-tetgen: reads a surface from standard input, lets TetGen make constrained Delaunay
// tetrahedra of its convex hull, and writes them to standard output (TetgenProtocol.h). TetGen
// exits, aborts, loops or corrupts memory on some surfaces; here this affects only this process.

#include "LeaveSteinerPoints.h"
#include "Tetrahedralize/TetgenProtocol.h"

#include <tetgen.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <limits>
#include <new>
#include <string>
#include <vector>

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

using namespace insideout::tetgenprotocol;

namespace
{
/** Exit statuses for a missing parent, or an invalid request. */
constexpr int BadRequest = 2;
constexpr int NobodyListens = 3;

struct Request
{
  bool LeaveSteinerPoints = false;
  std::vector<double> Points;
  std::vector<std::int32_t> Facets;
};

void ReadBytes(void* data, std::size_t bytes)
{
  char* to = static_cast<char*>(data);
  while (bytes > 0)
  {
    const ssize_t got = read(STDIN_FILENO, to, bytes);
    if (got > 0)
    {
      to += got;
      bytes -= static_cast<std::size_t>(got);
    }
    else if (got == 0 || errno != EINTR)
    {
      _exit(BadRequest);
    }
  }
}

void WriteBytes(int descriptor, const void* data, std::size_t bytes)
{
  const char* from = static_cast<const char*>(data);
  while (bytes > 0)
  {
    const ssize_t put = write(descriptor, from, bytes);
    if (put >= 0)
    {
      from += put;
      bytes -= static_cast<std::size_t>(put);
    }
    else if (errno != EINTR)
    {
      _exit(NobodyListens);
    }
  }
}

Request ReadRequest()
{
  RequestHeader header;
  ReadBytes(&header, sizeof(header));
  if (header.Magic != RequestMagic || header.LeaveSteinerPoints < 0 ||
    header.LeaveSteinerPoints > 1 || header.NumberOfPoints < 4 ||
    header.NumberOfPoints > MaximumCount || header.NumberOfFacets < 0 ||
    header.NumberOfFacets > MaximumCount)
  {
    _exit(BadRequest);
  }
  Request request;
  request.LeaveSteinerPoints = header.LeaveSteinerPoints == 1;
  request.Points.resize(3 * static_cast<std::size_t>(header.NumberOfPoints));
  request.Facets.resize(3 * static_cast<std::size_t>(header.NumberOfFacets));
  ReadBytes(request.Points.data(), request.Points.size() * sizeof(double));
  ReadBytes(request.Facets.data(), request.Facets.size() * sizeof(std::int32_t));
  for (const std::int32_t corner : request.Facets)
  {
    if (corner < 0 || corner >= header.NumberOfPoints)
    {
      _exit(BadRequest);
    }
  }
  return request;
}

/**
 * The request in TetGen's format; each facet has its own marker, or coplanar ones would be merged.
 */
void FillInput(const Request& request, tetgenio& input)
{
  input.numberofpoints = static_cast<int>(request.Points.size() / 3);
  input.pointlist = new double[request.Points.size()];
  std::copy(request.Points.begin(), request.Points.end(), input.pointlist);
  const int facets = static_cast<int>(request.Facets.size() / 3);
  input.facetlist = new tetgenio::facet[facets];
  input.facetmarkerlist = new int[facets];
  for (int f = 0; f < facets; ++f)
  {
    tetgenio::facet& facet = input.facetlist[f];
    tetgenio::init(&facet);
    facet.polygonlist = new tetgenio::polygon[1];
    facet.numberofpolygons = 1;
    tetgenio::init(&facet.polygonlist[0]);
    facet.polygonlist[0].vertexlist = new int[3];
    facet.polygonlist[0].numberofvertices = 3;
    std::copy_n(
      &request.Facets[3 * static_cast<std::size_t>(f)], 3, facet.polygonlist[0].vertexlist);
    input.facetmarkerlist[f] = f + 1;
    input.numberoffacets = f + 1;
  }
}

/**
 * TetGen's manual, section 4.2. c: the whole convex hull; J: keep unused points, so that ids stay;
 * Q: quiet; p: facets are constraints; M: merge neither coplanar facets nor points; Y: no Steiner
 * points on facets and segments, if TetGen can avoid it; Y0: only to recover them; l: the first
 * Delaunay tetrahedra by flips instead of Bowyer and Watson's cavities; b0: points in the order
 * given.
 */
std::string Switches(const Request& request)
{
  std::string switches = "cJQ";
  if (!request.Facets.empty())
  {
    switches += request.LeaveSteinerPoints ? "pMY0" : "pMY";
  }
  return request.LeaveSteinerPoints ? switches + "lb0" : switches;
}

/**
 * TetGen's tolerance has two effects. It distinguishes flat from solid by inexact arithmetic in the
 * search for the first cell: with no tolerance (T0) the first cell may be flat, and TetGen aborts
 * or loops. And it drops points near others: the least double as minedgelength keeps them all. No
 * reason for the value is recorded.
 */
tetgenbehavior Behavior(const Request& request)
{
  constexpr double ToleranceOfFirstCell = 1e-13;
  tetgenbehavior behavior;
  std::string switches = Switches(request);
  behavior.parse_commandline(&switches[0]);
  behavior.epsilon = ToleranceOfFirstCell;
  behavior.minedgelength = std::numeric_limits<double>::min();
  return behavior;
}

std::string Words(int thrown)
{
  switch (thrown)
  {
    case 1:
      return "it ran out of memory";
    case 2:
      return "it met an internal error";
    case 3:
      return "it holds that two facets intersect";
    case 4:
      return "it met a feature too small for it";
    case 5:
      return "it met two facets too close to each other";
    case 10:
      return "it does not accept the input";
    default:
      return "it gave up with code " + std::to_string(thrown);
  }
}

void WriteFailure(int descriptor, int status, const std::string& message)
{
  const AnswerHeader header = { AnswerMagic, status, static_cast<std::int64_t>(message.size()), 0,
    0, 0 };
  WriteBytes(descriptor, &header, sizeof(header));
  WriteBytes(descriptor, message.data(), message.size());
}

void WriteMesh(int descriptor, const tetgenio& mesh)
{
  // Markers of facets count from 1; faces with another marker are on the hull.
  std::vector<std::int32_t> faces;
  std::vector<std::int32_t> facets;
  for (std::size_t face = 0; face < static_cast<std::size_t>(mesh.numberoftrifaces); ++face)
  {
    if (mesh.trifacemarkerlist && mesh.trifacemarkerlist[face] > 0)
    {
      faces.insert(faces.end(), &mesh.trifacelist[3 * face], &mesh.trifacelist[3 * face] + 3);
      facets.push_back(mesh.trifacemarkerlist[face] - 1);
    }
  }
  const AnswerHeader header = { AnswerMagic, 0, 0, mesh.numberofpoints, mesh.numberoftetrahedra,
    static_cast<std::int64_t>(facets.size()) };
  WriteBytes(descriptor, &header, sizeof(header));
  WriteBytes(
    descriptor, mesh.pointlist, 3 * sizeof(double) * static_cast<std::size_t>(mesh.numberofpoints));
  WriteBytes(descriptor, mesh.tetrahedronlist,
    4 * sizeof(std::int32_t) * static_cast<std::size_t>(mesh.numberoftetrahedra));
  WriteBytes(descriptor, faces.data(), faces.size() * sizeof(std::int32_t));
  WriteBytes(descriptor, facets.data(), facets.size() * sizeof(std::int32_t));
}

/** Redirect standard output, to which TetGen prints. @return the descriptor for answers */
int TakeStandardOutput()
{
  const int answers = dup(STDOUT_FILENO);
  const int nowhere = open("/dev/null", O_WRONLY);
  if (answers < 0 || nowhere < 0 || dup2(nowhere, STDOUT_FILENO) < 0 ||
    dup2(nowhere, STDERR_FILENO) < 0)
  {
    _exit(NobodyListens);
  }
  return answers;
}

/** No core file if TetGen crashes, and no survival of the parent's end. */
void BindToParent()
{
  const rlimit none = { 0, 0 };
  setrlimit(RLIMIT_CORE, &none);
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
}

/** If memory runs out, the kernel should end this process and not its parent. */
void VolunteerToBeEnded()
{
  const int file = open("/proc/self/oom_score_adj", O_WRONLY);
  if (file >= 0)
  {
    WriteBytes(file, "1000", 4);
    close(file);
  }
}

/** Whether the parent ended before this process was bound to it; no request follows then. */
bool ParentIsGone()
{
  pollfd input = { STDIN_FILENO, 0, 0 };
  return poll(&input, 1, 0) == 1 && (input.revents & (POLLHUP | POLLERR));
}
} // namespace

int main()
{
  BindToParent();
  VolunteerToBeEnded();
  const int answers = TakeStandardOutput();
  try
  {
    tetgenio input;
    tetgenio mesh;
    tetgenbehavior behavior;
    {
      const Request request = ReadRequest();
      FillInput(request, input);
      behavior = Behavior(request);
      if (request.LeaveSteinerPoints)
      {
        LeaveSteinerPoints();
      }
    }
    if (ParentIsGone())
    {
      _exit(NobodyListens);
    }
    tetrahedralize(&behavior, &input, &mesh);
    WriteMesh(answers, mesh);
    // Exit without destructors: TetGen may have damaged memory, and the answer is written.
    _exit(0);
  }
  catch (int thrown)
  {
    WriteFailure(answers, thrown, Words(thrown));
  }
  catch (const std::bad_alloc&)
  {
    WriteFailure(answers, 1, Words(1));
  }
  _exit(0);
}

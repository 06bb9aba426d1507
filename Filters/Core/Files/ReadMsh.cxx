// SPDX-License-Identifier: GPL-3.0-or-later
#include "Files/NameNumbers.h"
#include "Files/SolidBuilder.h"
#include "Files/SolidReaders.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

// The formats: Geuzaine and Remacle, Gmsh Reference Manual, "MSH file format" and "Legacy formats".

namespace insideout
{
namespace
{
constexpr std::size_t SurfaceDimension = 2;
constexpr std::size_t VolumeDimension = 3;

/** Gmsh's types of elements. */
struct MshType
{
  std::int64_t Type;
  std::size_t Corners;
  std::size_t Nodes;
};

constexpr MshType Triangle3 = { 2, 3, 3 };
constexpr MshType Triangle6 = { 9, 3, 6 };
constexpr MshType Tetrahedron4 = { 4, 4, 4 };
constexpr MshType Tetrahedron10 = { 11, 4, 10 };

/** Names, for messages, of elements that are not read; empty for points and lines. */
std::string NameOfType(std::int64_t type)
{
  const std::pair<const char*, std::vector<std::int64_t>> names[] = {
    { "", { 1, 8, 15, 26, 27, 28, 62, 63, 64, 65, 66 } },
    { "quadrangles", { 3, 10, 16 } },
    { "hexahedra", { 5, 12, 17 } },
    { "prisms", { 6, 13, 18 } },
    { "pyramids", { 7, 14, 19 } },
    { "triangles of a higher order", { 20, 21, 22, 23, 24, 25 } },
    { "tetrahedra of a higher order", { 29, 30, 31 } },
  };
  for (const auto& [name, types] : names)
  {
    if (std::find(types.begin(), types.end(), type) != types.end())
    {
      return name;
    }
  }
  return "elements of type " + std::to_string(type);
}

/** The number of a group: negative ones are reversed. */
std::int64_t WithoutSign(std::int64_t group)
{
  return group < 0 ? std::max(group, -std::numeric_limits<std::int64_t>::max()) * -1 : group;
}

/** In version 2 an element of several groups is repeated for each: keep the first. */
void DropCopies(FileElements& elements)
{
  const auto nodesOf = [&elements](const FileElement& element)
  {
    const auto begin = elements.Nodes.begin() + static_cast<std::ptrdiff_t>(element.Begin);
    return std::make_pair(begin, begin + static_cast<std::ptrdiff_t>(elements.Corners));
  };
  std::vector<std::size_t> order(elements.All.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b)
    {
      const auto [begin, end] = nodesOf(elements.All[a]);
      const auto [otherBegin, otherEnd] = nodesOf(elements.All[b]);
      return std::lexicographical_compare(begin, end, otherBegin, otherEnd);
    });
  std::vector<bool> isCopy(order.size());
  for (std::size_t i = 1; i < order.size(); ++i)
  {
    const auto [begin, end] = nodesOf(elements.All[order[i - 1]]);
    isCopy[order[i]] = std::equal(begin, end, nodesOf(elements.All[order[i]]).first);
  }
  std::size_t kept = 0;
  for (std::size_t e = 0; e < elements.All.size(); ++e)
  {
    if (!isCopy[e])
    {
      elements.All[kept++] = elements.All[e];
    }
  }
  elements.All.resize(kept);
}

class MshReader
{
public:
  MshReader(const FileContent& file, Monitor& monitor)
    : Scanner(file, file.TextBegin(), 1, { false, false }, monitor)
    , Builder(file)
  {
  }

  SolidContent Read()
  {
    this->ReadFormat();
    while (this->Scanner.SkipToContent())
    {
      this->ReadSection(std::string(this->Scanner.Word()));
    }
    if (!this->IsVersion4)
    {
      DropCopies(this->Builder.Triangles);
      DropCopies(this->Builder.Tetrahedra);
    }
    for (const auto& [type, count] : this->OtherTypes)
    {
      const std::string name = NameOfType(type);
      this->Builder.AddOthers(name, name.empty() ? 0 : count);
    }
    return this->Builder.Finish();
  }

private:
  void ReadFormat()
  {
    if (!this->Scanner.SkipToContent() || this->Scanner.Word() != "$MeshFormat")
    {
      this->Scanner.Fail(
        "is not a file of gmsh's from version 2 on: $MeshFormat has to come first");
    }
    this->Need();
    const std::string version(this->Scanner.Word());
    this->IsVersion4 = version == "4.1";
    if (!this->IsVersion4 && version != "2" && version.compare(0, 2, "2.") != 0)
    {
      this->Scanner.Fail("is of version " + Quoted(version) +
        " of gmsh's format; versions 4.1 and 2.2 can be read (gmsh writes them: -format msh41)");
    }
    if (this->Integer() != 0)
    {
      this->Scanner.Fail(
        "is binary; text can be read (gmsh writes it without -bin, and Mesh.Binary 0)");
    }
    this->Integer();
    this->ExpectWord("$EndMeshFormat");
  }

  void ReadSection(const std::string& name)
  {
    if (name.empty() || name[0] != '$')
    {
      this->Scanner.Fail("expected a section, as $Nodes, found " + Quoted(name));
    }
    if (name == "$PhysicalNames")
    {
      this->ReadNames();
    }
    else if (name == "$Entities" && this->IsVersion4)
    {
      this->ReadEntities();
    }
    else if (name == "$Nodes")
    {
      this->IsVersion4 ? this->ReadBlocksOfNodes() : this->ReadNodes();
    }
    else if (name == "$Elements")
    {
      this->IsVersion4 ? this->ReadBlocksOfElements() : this->ReadElements();
    }
    else
    {
      this->SkipSection("$End" + name.substr(1));
      return;
    }
    this->ExpectWord("$End" + name.substr(1));
  }

  void SkipSection(const std::string& end)
  {
    do
    {
      this->Scanner.SkipLine();
      this->Need();
    } while (TextScanner(this->Scanner).Word() != end);
    this->Scanner.Word();
  }

  void ReadNames()
  {
    for (std::int64_t left = this->Integer(); left > 0; --left)
    {
      const std::int64_t dimension = this->Integer();
      const std::int64_t number = this->Integer();
      this->Need();
      const TextScanner before = this->Scanner;
      this->Scanner.SkipLine();
      const std::string_view line(before.Position(), before.Left() - this->Scanner.Left());
      const std::size_t last = line.rfind('"');
      if (line[0] != '"' || last == 0)
      {
        before.Fail("the name of a physical group has to stand in quotes");
      }
      const std::string name = ToUtf8(std::string(line.substr(1, last - 1)));
      if (FileElements* elements = this->ElementsOf(dimension))
      {
        elements->NamesOfGroups[number] = name;
      }
    }
  }

  FileElements* ElementsOf(std::int64_t dimension)
  {
    return dimension == SurfaceDimension ? &this->Builder.Triangles
      : dimension == VolumeDimension     ? &this->Builder.Tetrahedra
                                         : nullptr;
  }

  /** The physical group of each surface and volume. */
  void ReadEntities()
  {
    std::array<std::int64_t, 4> counts;
    for (std::int64_t& count : counts)
    {
      count = this->Integer();
    }
    for (std::size_t dimension = 0; dimension < counts.size(); ++dimension)
    {
      for (std::int64_t left = counts[dimension]; left > 0; --left)
      {
        const std::int64_t entity = this->Integer();
        const int coordinates = dimension == 0 ? 3 : 6;
        for (int k = 0; k < coordinates; ++k)
        {
          this->Need();
          this->Scanner.Number();
        }
        for (std::int64_t groups = this->Integer(); groups > 0; --groups)
        {
          this->Groups[dimension].emplace(entity, WithoutSign(this->Integer()));
        }
        for (std::int64_t sides = dimension > 0 ? this->Integer() : 0; sides > 0; --sides)
        {
          this->Integer();
        }
      }
    }
  }

  void ReadNodes()
  {
    constexpr std::uint64_t shortest = 8; // "1 0 0 0\n"
    for (std::int64_t left = this->Count(shortest, "points"); left > 0; --left)
    {
      const std::int64_t number = this->Integer();
      this->ReadPoint(number);
    }
  }

  void ReadPoint(std::int64_t number)
  {
    Point point;
    for (double& x : point)
    {
      this->Need();
      x = this->Scanner.Number();
    }
    this->Builder.AddPoint(this->Scanner, number, point);
  }

  void ReadBlocksOfNodes()
  {
    std::int64_t blocks = this->Integer();
    constexpr std::uint64_t shortest = 8; // "1\n0 0 0\n"
    std::int64_t points = this->Count(shortest, "points");
    this->Integer();
    this->Integer();
    std::vector<std::int64_t> numbers;
    for (; blocks > 0; --blocks)
    {
      this->Integer(); // dimension and entity
      this->Integer();
      const bool isParametric = this->Integer() != 0;
      const std::int64_t count = this->Count(shortest, "points");
      points -= count;
      numbers.clear();
      for (std::int64_t p = 0; p < count; ++p)
      {
        numbers.push_back(this->Integer());
      }
      for (const std::int64_t number : numbers)
      {
        this->ReadPoint(number);
        if (isParametric)
        {
          this->Scanner.SkipLine();
        }
      }
    }
    this->ExpectNoMore(points, "points");
  }

  void ReadElements()
  {
    constexpr std::uint64_t shortest = 7; // "1 15 0\n", and a point
    for (std::int64_t left = this->Count(shortest, "elements"); left > 0; --left)
    {
      this->Need();
      FileElement element = { 0, this->Scanner.GetLine() };
      element.Number = this->Scanner.Integer();
      const std::int64_t type = this->Scanner.Integer();
      const std::int64_t tags = this->Scanner.Integer();
      for (std::int64_t t = 0; t < tags; ++t)
      {
        const std::int64_t tag = this->Scanner.Integer();
        element.Group = t == 0 ? WithoutSign(tag) : element.Group;
        element.Entity = t == 1 ? tag : element.Entity;
      }
      this->ReadElement(type, element);
    }
  }

  void ReadBlocksOfElements()
  {
    std::int64_t blocks = this->Integer();
    constexpr std::uint64_t shortest = 4; // "1 2\n"
    std::int64_t elements = this->Count(shortest, "elements");
    this->Integer();
    this->Integer();
    for (; blocks > 0; --blocks)
    {
      const std::int64_t dimension = this->Integer();
      const std::int64_t entity = this->Integer();
      const std::int64_t type = this->Integer();
      const std::int64_t count = this->Count(shortest, "elements");
      elements -= count;
      std::int64_t group = 0;
      if (dimension >= 0 && dimension <= std::int64_t(VolumeDimension))
      {
        const auto& groups = this->Groups[static_cast<std::size_t>(dimension)];
        const auto found = groups.find(entity);
        group = found == groups.end() ? 0 : found->second;
      }
      for (std::int64_t e = 0; e < count; ++e)
      {
        this->Need();
        FileElement element = { 0, this->Scanner.GetLine(), group, entity };
        element.Number = this->Scanner.Integer();
        this->ReadElement(type, element);
      }
    }
    this->ExpectNoMore(elements, "elements");
  }

  /** The points of an element, from its line. */
  void ReadElement(std::int64_t type, const FileElement& element)
  {
    for (const MshType& known : { Triangle3, Triangle6, Tetrahedron4, Tetrahedron10 })
    {
      if (type != known.Type)
      {
        continue;
      }
      this->Nodes.resize(known.Nodes);
      for (std::int64_t& node : this->Nodes)
      {
        node = this->Scanner.Integer();
      }
      if (!this->Scanner.AtLineEnd())
      {
        this->Scanner.Fail("element " + std::to_string(element.Number) + " has more than " +
          std::to_string(known.Nodes) + " points");
      }
      if (type == Tetrahedron10.Type)
      {
        std::swap(this->Nodes[8], this->Nodes[9]); // edge 2 3 comes before edge 1 3
      }
      const bool isTriangle = known.Corners == Triangle3.Corners;
      SolidBuilder::AddElement(
        isTriangle ? this->Builder.Triangles : this->Builder.Tetrahedra, element, this->Nodes);
      return;
    }
    ++this->OtherTypes[type];
    this->Scanner.SkipLine();
  }

  std::int64_t Count(std::uint64_t shortest, const char* things)
  {
    const std::int64_t count = this->Integer();
    CheckAnnounced(this->Scanner, count, shortest, things);
    return count;
  }

  void ExpectNoMore(std::int64_t left, const char* things)
  {
    if (left != 0)
    {
      this->Scanner.Fail(std::string("the blocks have other ") + things + " than were announced: " +
        std::to_string(left > 0 ? left : -left) + (left > 0 ? " less" : " more"));
    }
  }

  void ExpectWord(const std::string& word)
  {
    this->Need();
    const std::string found(this->Scanner.Word());
    if (found != word)
    {
      this->Scanner.Fail("expected " + word + ", found " + Quoted(found));
    }
  }

  std::int64_t Integer()
  {
    this->Need();
    return this->Scanner.Integer();
  }

  void Need()
  {
    if (!this->Scanner.SkipToContent())
    {
      this->Scanner.Fail("the file is truncated");
    }
  }

  TextScanner Scanner;
  SolidBuilder Builder;
  bool IsVersion4 = false;
  std::array<std::map<std::int64_t, std::int64_t>, 4> Groups; ///< the first group of each entity
  std::map<std::int64_t, std::int64_t> OtherTypes;            ///< number of those not read
  std::vector<std::int64_t> Nodes;
};
} // namespace

SolidContent ReadMsh(const FileContent& file, Monitor& monitor)
{
  return MshReader(file, monitor).Read();
}
} // namespace insideout

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ForPython/WriteFile.h"

#include "Files/OutputFile.h"
#include "ForPython/DataForXml.h"
#include "ForPython/Listening.h"
#include "ForPython/Spool.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLImageDataWriter.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <ostream>
#include <string>

using namespace insideout;

namespace
{
/** One of VTK's writers, into a stream. */
template <typename Writer>
class StreamWriter : public Writer
{
public:
  static StreamWriter* New()
  {
    auto* writer = new StreamWriter;
    writer->InitializeObjectBase();
    return writer;
  }

  void SetStream(std::ostream* stream) { this->Stream = stream; }
};

/** Write a file, and report errors to the listener. */
template <typename Write>
void WriteTo(const std::string& path, vtkInsideOutListener listener, const Write& write)
{
  vtkInsideOut::TellWhatFails(listener, path + ": ", "not enough memory to write it",
    [&]()
    {
      vtkInsideOut::ListeningMonitor monitor(listener);
      OutputFile file(path, monitor);
      write(file);
      file.Close();
    });
}

template <typename Writer>
void WriteData(vtkDataSet* data, const std::string& path, vtkInsideOutListener listener)
{
  // The level of zlib compression. Every reader of VTK's XML files supports zlib. VTK's default
  // takes 2.5 times as long to write a solid of 123,000 tetrahedra, for 7 % fewer bytes.
  constexpr int fastestCompression = 1;
  vtkInsideOut::Spool spool;
  {
    std::ostream stream(&spool);
    vtkNew<StreamWriter<Writer>> writer;
    writer->SetStream(&stream);
    writer->SetInputData(vtkInsideOut::DataForXml(data));
    writer->SetDataModeToBinary();
    writer->SetCompressionLevel(fastestCompression);
    if (!vtkInsideOutUpdate(static_cast<vtkObjectBase*>(writer.Get()), 1, listener))
    {
      return;
    }
  }
  WriteTo(path, listener,
    [&](OutputFile& file)
    {
      spool.MoveTo(file);
      file.Text("<!-- Written by InsideOut -->\n"); // distinguishes it from files of other programs
    });
}
} // namespace

extern "C" void vtkInsideOutWriteData(void* object, const char* path, vtkInsideOutListener listener)
{
  auto* data = vtkDataSet::SafeDownCast(static_cast<vtkObjectBase*>(object));
  if (vtkUnstructuredGrid::SafeDownCast(data))
  {
    WriteData<vtkXMLUnstructuredGridWriter>(data, path, listener);
  }
  else if (vtkPolyData::SafeDownCast(data))
  {
    WriteData<vtkXMLPolyDataWriter>(data, path, listener);
  }
  else if (vtkImageData::SafeDownCast(data))
  {
    WriteData<vtkXMLImageDataWriter>(data, path, listener);
  }
  else
  {
    const std::string why = std::string(path) + ": a " +
      static_cast<vtkObjectBase*>(object)->GetClassName() + " cannot be written";
    listener(VTK_INSIDEOUT_ERROR, why.c_str(), 0);
  }
}

extern "C" void vtkInsideOutWriteBytes(
  const char* bytes, std::size_t length, const char* path, vtkInsideOutListener listener)
{
  WriteTo(path, listener, [&](OutputFile& file) { file.Text({ bytes, length }); });
}

extern "C" void vtkInsideOutRemoveUnfinishedFiles()
{
  UnfinishedFile::RemoveAllForGood();
}

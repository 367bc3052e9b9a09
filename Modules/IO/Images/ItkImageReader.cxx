#include "ItkImageReader.h"

#include "CNumericLocale.h"
#include "ItkCompiler.h"
#include "QuietStandardStreams.h"

#include "itkMetaDataObject.h"
#include "itkMetaImageIO.h"
#include "itkNrrdImageIO.h"
#include "vtkType.h"

#include <stdexcept>

namespace palpate
{
struct ItkImageReader::Implementation
{
  itk::ImageIOBase::Pointer Io;
};

namespace
{
itk::ImageIOBase::Pointer NewImageIo(ItkFormat format)
{
  return format == ItkFormat::Nrrd ? itk::ImageIOBase::Pointer(itk::NrrdImageIO::New())
                                   : itk::ImageIOBase::Pointer(itk::MetaImageIO::New());
}

int VtkTypeOf(itk::IOComponentEnum type)
{
  switch (type)
  {
  case itk::IOComponentEnum::UCHAR:
    return VTK_UNSIGNED_CHAR;
  case itk::IOComponentEnum::CHAR:
    return VTK_SIGNED_CHAR;
  case itk::IOComponentEnum::USHORT:
    return VTK_UNSIGNED_SHORT;
  case itk::IOComponentEnum::SHORT:
    return VTK_SHORT;
  case itk::IOComponentEnum::UINT:
    return VTK_UNSIGNED_INT;
  case itk::IOComponentEnum::INT:
    return VTK_INT;
  case itk::IOComponentEnum::ULONG:
    return VTK_UNSIGNED_LONG;
  case itk::IOComponentEnum::LONG:
    return VTK_LONG;
  case itk::IOComponentEnum::ULONGLONG:
    return VTK_UNSIGNED_LONG_LONG;
  case itk::IOComponentEnum::LONGLONG:
    return VTK_LONG_LONG;
  case itk::IOComponentEnum::FLOAT:
    return VTK_FLOAT;
  case itk::IOComponentEnum::DOUBLE:
    return VTK_DOUBLE;
  default:
    return 0;
  }
}
} // namespace

ItkImageReader::ItkImageReader(const std::filesystem::path& file, ItkFormat format)
    : Itk(std::make_unique<Implementation>())
{
  const QuietStandardStreams quiet;
  const CNumericLocale numbers;
  this->Itk->Io = NewImageIo(format);
  this->Itk->Io->SetFileName(file.string());
  if (!this->Itk->Io->CanReadFile(file.c_str()))
  {
    throw std::runtime_error("not a file of this kind");
  }
  this->Itk->Io->ReadImageInformation();
}

ItkImageReader::~ItkImageReader() = default;

ItkImageHeader ItkImageReader::Header() const
{
  const itk::ImageIOBase& io = *this->Itk->Io;
  ItkImageHeader header;
  for (unsigned int axis = 0; axis < io.GetNumberOfDimensions(); ++axis)
  {
    header.Size.push_back(static_cast<long long>(io.GetDimensions(axis)));
    header.Spacing.push_back(io.GetSpacing(axis));
    header.OriginWorld.push_back(io.GetOrigin(axis));
    header.AxesWorld.push_back(io.GetDirection(axis));
  }
  header.Components = static_cast<int>(io.GetNumberOfComponents());
  header.VtkType = VtkTypeOf(io.GetComponentType());
  const itk::MetaDataDictionary& dictionary = io.GetMetaDataDictionary();
  for (const std::string& key : dictionary.GetKeys())
  {
    std::string value;
    if (itk::ExposeMetaData<std::string>(dictionary, key, value))
    {
      header.Entries.emplace(key, value);
    }
  }
  return header;
}

void ItkImageReader::ReadInto(void* buffer)
{
  const QuietStandardStreams quiet;
  const CNumericLocale numbers;
  itk::ImageIOBase& io = *this->Itk->Io;
  const unsigned int dimensions = io.GetNumberOfDimensions();
  itk::ImageIORegion region(dimensions);
  for (unsigned int axis = 0; axis < dimensions; ++axis)
  {
    region.SetIndex(axis, 0);
    region.SetSize(axis, io.GetDimensions(axis));
  }
  io.SetIORegion(region);
  io.Read(buffer);
}
} // namespace palpate

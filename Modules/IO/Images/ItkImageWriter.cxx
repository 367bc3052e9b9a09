#include "ItkImageWriter.h"

#include "CNumericLocale.h"
#include "ItkCompiler.h"
#include "QuietStandardStreams.h"

#include "itkMetaImageIO.h"
#include "itkNiftiImageIO.h"
#include "itkNrrdImageIO.h"
#include "vtkMatrix3x3.h"

#include <vector>

namespace palpate
{
namespace
{
itk::ImageIOBase::Pointer NewWritingIo(ItkFormat format)
{
  switch (format)
  {
  case ItkFormat::Nifti:
    return itk::NiftiImageIO::New().GetPointer();
  case ItkFormat::Nrrd:
    return itk::NrrdImageIO::New().GetPointer();
  case ItkFormat::MetaImage:
    break;
  }
  return itk::MetaImageIO::New().GetPointer();
}

itk::IOComponentEnum ItkTypeOf(int vtkType)
{
  switch (vtkType)
  {
  case VTK_UNSIGNED_CHAR:
    return itk::IOComponentEnum::UCHAR;
  case VTK_CHAR:
  case VTK_SIGNED_CHAR:
    return itk::IOComponentEnum::CHAR;
  case VTK_UNSIGNED_SHORT:
    return itk::IOComponentEnum::USHORT;
  case VTK_SHORT:
    return itk::IOComponentEnum::SHORT;
  case VTK_UNSIGNED_INT:
    return itk::IOComponentEnum::UINT;
  case VTK_INT:
    return itk::IOComponentEnum::INT;
  case VTK_FLOAT:
    return itk::IOComponentEnum::FLOAT;
  case VTK_DOUBLE:
    return itk::IOComponentEnum::DOUBLE;
  default:
    return itk::IOComponentEnum::UNKNOWNCOMPONENTTYPE;
  }
}

void SetGeometry(itk::ImageIOBase* io, vtkImageData* image)
{
  itk::ImageIORegion region(3);
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    const int k = static_cast<int>(axis);
    const auto size = static_cast<itk::SizeValueType>(image->GetDimensions()[k]);
    io->SetDimensions(axis, size);
    io->SetSpacing(axis, image->GetSpacing()[k]);
    std::vector<double> axisWorld;
    for (int row = 0; row < 3; ++row)
    {
      axisWorld.push_back(image->GetDirectionMatrix()->GetElement(row, k));
    }
    io->SetDirection(axis, axisWorld);
    region.SetIndex(axis, 0);
    region.SetSize(axis, size);
  }
  // Position of the first voxel, which differs from VTK's origin if the extent does not start at 0.
  double first[3];
  image->TransformIndexToPhysicalPoint(image->GetExtent()[0], image->GetExtent()[2],
                                       image->GetExtent()[4], first);
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    io->SetOrigin(axis, first[axis]);
  }
  io->SetIORegion(region);
}
} // namespace

bool IsItkType(int vtkType)
{
  return ItkTypeOf(vtkType) != itk::IOComponentEnum::UNKNOWNCOMPONENTTYPE;
}

void WriteWithItk(ItkFormat format, const std::filesystem::path& file, vtkImageData* image,
                  vtkDataArray* voxels, bool isCompressed)
{
  const QuietStandardStreams quiet;
  const CNumericLocale numbers;
  const itk::ImageIOBase::Pointer io = NewWritingIo(format);
  io->SetFileName(file.string());
  io->SetNumberOfDimensions(3);
  SetGeometry(io, image);
  io->SetPixelType(itk::IOPixelEnum::SCALAR);
  io->SetNumberOfComponents(1);
  io->SetComponentType(ItkTypeOf(voxels->GetDataType()));
  io->SetUseCompression(isCompressed);
  io->Write(voxels->GetVoidPointer(0));
}
} // namespace palpate

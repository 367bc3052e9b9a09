#include "ImageWriter.h"

#include "AtomicFile.h"
#include "CNumericLocale.h"
#include "FileEnding.h"
#include "ImageReadBack.h"
#include "MemoryCheck.h"
#include "QuietStandardStreams.h"
#include "Refusal.h"

#include "itkMetaImageIO.h"
#include "itkNiftiImageIO.h"
#include "itkNrrdImageIO.h"
#include "vtkDataArray.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <exception>
#include <string>
#include <vector>

namespace palpate
{
namespace
{
// Nothing where the ending is not one of ours.
itk::ImageIOBase::Pointer NewImageIo(const std::string& ending)
{
  if (ending == ".nii" || ending == ".nii.gz")
  {
    return itk::NiftiImageIO::New().GetPointer();
  }
  if (ending == ".nrrd")
  {
    return itk::NrrdImageIO::New().GetPointer();
  }
  if (ending == ".mha")
  {
    return itk::MetaImageIO::New().GetPointer();
  }
  return nullptr;
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
  // The first voxel's place, which is not VTK's origin where an extent starts elsewhere than at 0.
  double first[3];
  image->TransformIndexToPhysicalPoint(image->GetExtent()[0], image->GetExtent()[2],
                                       image->GetExtent()[4], first);
  for (unsigned axis = 0; axis < 3; ++axis)
  {
    io->SetOrigin(axis, first[axis]);
  }
  io->SetIORegion(region);
}

// 64-bit integers, which no format here holds, as 32-bit ones where those hold every value;
// else the voxels as they are.
vtkSmartPointer<vtkDataArray> Narrowed(const std::filesystem::path& path, vtkDataArray* voxels)
{
  const int type = voxels == nullptr ? VTK_VOID : voxels->GetDataType();
  if (type != VTK_LONG && type != VTK_UNSIGNED_LONG && type != VTK_LONG_LONG &&
      type != VTK_UNSIGNED_LONG_LONG && type != VTK_ID_TYPE)
  {
    return voxels;
  }
  const double* range = voxels->GetRange(0);
  const bool fitsSigned = range[0] >= VTK_INT_MIN && range[1] <= VTK_INT_MAX;
  const bool fitsUnsigned = range[0] >= 0.0 && range[1] <= VTK_UNSIGNED_INT_MAX;
  if (!fitsSigned && !fitsUnsigned)
  {
    return voxels;
  }
  CheckMemory(path, static_cast<double>(voxels->GetNumberOfValues()) * sizeof(int),
              AvailableMemoryBytes());
  auto narrowed = vtkSmartPointer<vtkDataArray>::Take(
      vtkDataArray::CreateDataArray(fitsSigned ? VTK_INT : VTK_UNSIGNED_INT));
  narrowed->DeepCopy(voxels);
  return narrowed;
}

void CheckWritable(const std::filesystem::path& path, vtkDataArray* voxels)
{
  if (voxels == nullptr || voxels->GetNumberOfTuples() == 0)
  {
    Refuse(path, "cannot be written: the image has no voxels", "make the image first");
  }
  if (voxels->GetNumberOfComponents() != 1)
  {
    Refuse(path, "cannot be written: the image has more than one value per voxel",
           "write its components one by one");
  }
  if (ItkTypeOf(voxels->GetDataType()) == itk::IOComponentEnum::UNKNOWNCOMPONENTTYPE)
  {
    Refuse(path,
           "cannot be written: no format holds voxels of type \"" +
               std::string(voxels->GetDataTypeAsString()) + "\"",
           "convert them to another type");
  }
}
} // namespace

bool IsWritableImage(const std::filesystem::path& path)
{
  return NewImageIo(FileEnding(path)) != nullptr;
}

void WriteImage(const std::filesystem::path& path, vtkImageData* image)
{
  const std::string ending = FileEnding(path);
  const itk::ImageIOBase::Pointer io = NewImageIo(ending);
  if (io == nullptr)
  {
    Refuse(path, "does not end as an image file that can be written does",
           "use .nii, .nii.gz, .nrrd or .mha");
  }
  const vtkSmartPointer<vtkDataArray> voxels = Narrowed(path, image->GetPointData()->GetScalars());
  CheckWritable(path, voxels);
  if (ending == ".mha")
  {
    CNumericLocale::RequireOfStreams(path);
  }
  AtomicFile file(path);
  io->SetFileName(file.TemporaryPath().string());
  io->SetNumberOfDimensions(3);
  SetGeometry(io, image);
  io->SetPixelType(itk::IOPixelEnum::SCALAR);
  io->SetNumberOfComponents(1);
  io->SetComponentType(ItkTypeOf(voxels->GetDataType()));
  io->SetUseCompression(ending != ".nii");
  bool complete = false;
  try
  {
    const QuietStandardStreams quiet;
    const CNumericLocale numbers;
    // ITK's writers of NRRD and MetaImage do not notice a full disk, so the file is read again.
    io->Write(voxels->GetVoidPointer(0));
    complete = HoldsVoxels(file.TemporaryPath(), voxels);
  }
  catch (const std::exception&)
  {
    complete = false;
  }
  if (!complete)
  {
    Refuse(path, "cannot be written: writing stopped early", "make room or choose another output");
  }
  file.Commit();
}
} // namespace palpate

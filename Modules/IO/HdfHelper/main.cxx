// palpate-transform-hdf5: reads and writes linear transforms in ITK's HDF5 files, in a process of
// its own because the HDF5 library is not safe on damaged files. Its standard input is the socket
// of a HdfTransform: it sends what it has read, or receives what it is to write, and then a byte.

#include "ItkCompiler.h"

#include "FrameExchange.h"
#include "ItkMapRows.h"
#include "ProcessLimits.h"

#include <exception>
#include <filesystem>
#include <string>
#include <unistd.h>

#include "itkAffineTransform.h"
#include "itkHDF5TransformIO.h"
#include "itkTransformFactoryBase.h"
#include "itkTranslationTransform.h"

namespace
{
using palpate::MapRows;
using File = itk::HDF5TransformIOTemplate<double>;

// Several times what a linear transform needs; a damaged file may ask for anything.
void LimitWork(const std::filesystem::path& file)
{
  constexpr rlim_t SomeMemory = rlim_t{64} << 20;
  constexpr rlim_t SomeSeconds = 5;
  std::error_code failure;
  const auto bytes = static_cast<rlim_t>(std::filesystem::file_size(file, failure));
  palpate::LimitResource(RLIMIT_AS,
                         palpate::MappedBytes() + SomeMemory + (failure ? 0 : 8 * bytes));
  palpate::LimitResource(RLIMIT_CPU, palpate::ProcessorSeconds() + SomeSeconds);
  alarm(static_cast<unsigned int>(12 * SomeSeconds));
}

bool Read(const std::string& path, MapRows& rows)
{
  const auto reader = File::New();
  reader->SetFileName(path);
  reader->Read();
  const auto& list = reader->GetReadTransformList();
  const auto* first = list.size() == 1 ? list.front().GetPointer() : nullptr;
  if (const auto* shift = dynamic_cast<const itk::TranslationTransform<double, 3>*>(first))
  {
    for (unsigned row = 0; row < 3; ++row)
    {
      rows[row] = {};
      rows[row][row] = 1.0;
      rows[row][3] = shift->GetOffset()[row];
    }
    return true;
  }
  const auto* linear = dynamic_cast<const itk::MatrixOffsetTransformBase<double, 3, 3>*>(first);
  if (linear != nullptr)
  {
    rows = palpate::RowsOf(*linear);
  }
  return linear != nullptr;
}

void Write(const std::string& path, const MapRows& rows)
{
  const auto affine = itk::AffineTransform<double, 3>::New();
  itk::AffineTransform<double, 3>::MatrixType matrix;
  itk::AffineTransform<double, 3>::OutputVectorType shift;
  for (unsigned row = 0; row < 3; ++row)
  {
    for (unsigned column = 0; column < 3; ++column)
    {
      matrix(row, column) = rows[row][column];
    }
    shift[row] = rows[row][3];
  }
  affine->SetMatrix(matrix);
  affine->SetTranslation(shift);
  const auto writer = File::New();
  writer->SetFileName(path);
  File::ConstTransformListType list{affine.GetPointer()};
  writer->SetTransformList(list);
  writer->Write();
}
} // namespace

int main(int count, char** words)
{
  constexpr int Words = 3; // the program, "read" or "write", a file
  if (count != Words)
  {
    return 2;
  }
  const std::string path = words[2];
  palpate::LimitResource(RLIMIT_CORE, 0);
  LimitWork(path);
  try
  {
    itk::TransformFactoryBase::RegisterDefaultTransforms();
    MapRows rows{};
    char isDone = 1;
    const bool reads = std::string(words[1]) == "read";
    if (reads ? Read(path, rows) && palpate::SendAll(STDIN_FILENO, rows.data(), sizeof(rows))
              : palpate::ReceiveAll(STDIN_FILENO, rows.data(), sizeof(rows)))
    {
      if (!reads)
      {
        Write(path, rows);
      }
      return palpate::SendAll(STDIN_FILENO, &isDone, 1) ? 0 : 1;
    }
  }
  catch (...) // HDF5's exceptions have no base
  {
  }
  return 1;
}

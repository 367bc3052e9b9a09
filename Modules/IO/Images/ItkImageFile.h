#pragma once

#include "ImageFile.h"
#include "ItkImageReader.h"

#include <filesystem>
#include <memory>
#include <string>

namespace palpate
{
class ItkImageFile : public ImageFile
{
public:
  void ReadInto(void* buffer) override;

protected:
  using ImageFile::ImageFile;
  /// Reads the header and its grid with ITK, without checking the grid. Throws InputError, naming
  /// the format.
  void OpenReader(ItkFormat format, const std::string& name);

private:
  void CheckHeader() const;
  void TakeGrid();

  std::unique_ptr<ItkImageReader> Reader;
};
} // namespace palpate

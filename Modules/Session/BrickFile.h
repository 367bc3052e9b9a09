#pragma once

#include "BrickRecords.h"
#include "PalpateSessionModule.h"

#include <filesystem>
#include <memory>

namespace palpate
{
/// The records of a field in a file without a name, which is gone when this or the program is.
class PALPATESESSION_EXPORT BrickFile final : public BrickSource
{
public:
  /// Writes all of a whole field's records, in a folder for what is temporary. Refuses where they
  /// cannot be written.
  static Status Make(const ScalarField& whole, const std::filesystem::path& folder,
                     std::unique_ptr<BrickSource>& source);
  ~BrickFile() override;

  Status Read(std::uint32_t number, std::byte* record) override;

private:
  BrickFile(int file, std::size_t recordBytes) : File(file), RecordBytes(recordBytes) {}

  int File;
  std::size_t RecordBytes;
};
} // namespace palpate

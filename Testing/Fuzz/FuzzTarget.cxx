#include "FuzzTarget.h"

#include "DeviceTargets.h"
#include "DicomTargets.h"
#include "ElasticTargets.h"
#include "ImageTargets.h"
#include "SessionTargets.h"
#include "SurfaceTargets.h"

#include <memory>
#include <stdexcept>
#include <utility>

namespace palpate::test
{
namespace
{
std::vector<FuzzTarget> MakeFuzzTargets()
{
  std::vector<FuzzTarget> all;
  for (auto* make : {&ImageTargets, &DicomTargets, &SurfaceTargets, &ElasticTargets,
                     &SessionTargets, &DeviceTargets})
  {
    for (FuzzTarget& target : (*make)())
    {
      all.push_back(std::move(target));
    }
  }
  return all;
}
} // namespace

const std::vector<FuzzTarget>& FuzzTargets()
{
  static const std::vector<FuzzTarget> all = MakeFuzzTargets();
  return all;
}

const FuzzTarget& FindFuzzTarget(const std::string& name)
{
  std::string names;
  for (const FuzzTarget& target : FuzzTargets())
  {
    if (target.Name == name)
    {
      return target;
    }
    names += " " + target.Name;
  }
  throw std::invalid_argument(name + " is not fuzzed; name one of" + names);
}

InputReader FileReader(const std::string& fileName,
                       std::function<void(const std::filesystem::path& file)> read,
                       const std::function<void(const std::filesystem::path& folder)>& prepare)
{
  const auto folder = std::make_shared<TemporaryFolder>();
  if (prepare)
  {
    prepare(folder->Path());
  }
  return [folder, file = *folder / fileName, readFile = std::move(read)](const std::string& bytes)
  {
    // A new file each time: rewriting one makes some file systems wait for the disk.
    std::filesystem::remove(file);
    WriteAll(file, bytes);
    readFile(file);
  };
}

std::string WrittenBytes(const std::string& fileName,
                         const std::function<void(const std::filesystem::path& file)>& write)
{
  const TemporaryFolder folder;
  write(folder / fileName);
  return ReadAll(folder / fileName);
}
} // namespace palpate::test

#pragma once

#include "Mutation.h"
#include "TemporaryFolder.h"

#include <filesystem>

namespace palpate::test
{
/// Reads an input as the program does. Throws InputError if it refuses; any other exception is a
/// defect.
using InputReader = std::function<void(const std::string& bytes)>;

/// A reader to fuzz: its seeds, its mutations, and how to call it.
struct FuzzTarget
{
  std::string Name;     ///< name of the format, unique
  std::string FileName; ///< file name of an input, with the ending that the reader expects
  std::function<std::vector<std::string>()> MakeSeeds; ///< valid inputs
  Mutator Mutate;
  std::function<InputReader()> MakeReader; ///< each reader has its own folder
};

/// All targets.
const std::vector<FuzzTarget>& FuzzTargets();
/// Throws std::invalid_argument that lists all names if `name` is unknown.
const FuzzTarget& FindFuzzTarget(const std::string& name);

/// A reader that writes each input to `fileName` in its own folder and passes that to `read`.
/// `prepare` may add other files to the folder.
InputReader
FileReader(const std::string& fileName, std::function<void(const std::filesystem::path& file)> read,
           const std::function<void(const std::filesystem::path& folder)>& prepare = {});

/// The bytes of the file that `write` writes.
std::string WrittenBytes(const std::string& fileName,
                         const std::function<void(const std::filesystem::path& file)>& write);
} // namespace palpate::test

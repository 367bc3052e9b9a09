#pragma once

#include "Mutation.h"
#include "TemporaryFolder.h"

#include <filesystem>

namespace palpate::test
{
/// Reads an input as the program does. Throws InputError for a refusal; anything else that leaves
/// it is a defect.
using InputReader = std::function<void(const std::string& bytes)>;

/// A reader that is fuzzed: what it reads, and how that is changed.
struct FuzzTarget
{
  std::string Name;     ///< of the format
  std::string FileName; ///< as the reader sees an input, where it reads files
  std::function<std::vector<std::string>()> MakeSeeds; ///< good inputs, all of which are read
  Mutator Mutate;
  std::function<InputReader()> MakeReader; ///< with files of its own
};

/// Every target, by module: a row a reader.
const std::vector<FuzzTarget>& FuzzTargets();
/// Throws std::invalid_argument, with all names, for an unknown one.
const FuzzTarget& FindFuzzTarget(const std::string& name);

/// A reader of one file in a folder of its own, which may hold other files.
InputReader
FileReader(const std::string& fileName, std::function<void(const std::filesystem::path& file)> read,
           const std::function<void(const std::filesystem::path& folder)>& prepare = {});

/// What `write` leaves in the file that it is given.
std::string WrittenBytes(const std::string& fileName,
                         const std::function<void(const std::filesystem::path& file)>& write);
} // namespace palpate::test

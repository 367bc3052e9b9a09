#pragma once

#include "OrganSoftening.h"
#include "PalpateFitModule.h"
#include "RadialModel.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace palpate
{
/// What softening made, kept in a folder of the user: model files with an elasticity, named by the
/// key of their inputs (SofteningKey), so that no name of a patient or file is in it. They are
/// readable only by the user. If they exceed the limit, the least recently used are removed. A
/// cache that cannot be read or written, or whose folder others can write to, is as good as empty:
/// nothing throws.
class PALPATEFIT_EXPORT SofteningCache
{
public:
  static constexpr std::uintmax_t UsualBytes = 200'000'000;

  struct Entry
  {
    std::shared_ptr<const ComplianceMaps> Elasticity;
    OrganSoftening::Account Account;
  };

  /// The folder is made when it is first written to.
  explicit SofteningCache(std::filesystem::path folder, std::uintmax_t mostBytes = UsualBytes);

  /// The entry of a key and model, checked as any model file is.
  std::optional<Entry> Find(const std::string& key, const RadialModel& model) const;
  void Store(const std::string& key, const RadialModel& model, const Entry& entry) const;

  /// \name The cache of this process
  /// There is none unless an application chooses a folder; an empty one switches it off again.
  ///@{
  static void UseInProcess(const std::filesystem::path& folder);
  static std::shared_ptr<const SofteningCache> OfProcess();
  ///@}

  /// For applications: PALPATE_CACHE_DIR, which may be set to nothing to have no cache; otherwise
  /// "palpate" in XDG_CACHE_HOME or ~/.cache. Empty for no cache.
  static std::filesystem::path UserFolder();

private:
  std::filesystem::path PathOf(const std::string& key) const;
  void Trim() const;

  std::filesystem::path Folder;
  std::uintmax_t MostBytes;
};
} // namespace palpate

#include "SofteningCache.h"

#include "ModelSoftening.h"
#include "SofteningKey.h"
#include "TemporaryFolder.h"
#include "WholeFile.h"

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <gtest/gtest.h>
#include <optional>
#include <set>
#include <sys/stat.h>
#include <utility>
#include <vector>

namespace palpate::softening_cache_test
{
namespace
{
namespace fs = std::filesystem;

bool GoOn(double, const std::string&)
{
  return true;
}

RadialModel Ball(double radius = 14.0)
{
  return {0, {radius * std::sqrt(4.0 * M_PI)}, Vector3::Zero()};
}

SofteningSettings Quick(double kilopascal = 20.0)
{
  SofteningSettings settings;
  settings.TissueKilopascal = kilopascal;
  settings.Numbers.ElementsAcross = 4;
  settings.Numbers.Degree = 4;
  settings.Numbers.Maps.Degree = 6;
  return settings;
}

unsigned ModeOf(const fs::path& path)
{
  struct stat found = {};
  return stat(path.c_str(), &found) == 0 ? found.st_mode & 0777U : 0U;
}

// Restores the environment.
class ChangedVariables
{
public:
  explicit ChangedVariables(const std::vector<std::string>& names)
  {
    for (const std::string& name : names)
    {
      const char* value = std::getenv(name.c_str());
      this->Before.emplace_back(name, value != nullptr ? std::optional<std::string>(value)
                                                       : std::nullopt);
    }
  }
  ChangedVariables(const ChangedVariables&) = delete;
  ChangedVariables& operator=(const ChangedVariables&) = delete;
  ~ChangedVariables()
  {
    for (const auto& [name, value] : this->Before)
    {
      value ? setenv(name.c_str(), value->c_str(), 1) : unsetenv(name.c_str());
    }
  }

private:
  std::vector<std::pair<std::string, std::optional<std::string>>> Before;
};

class SofteningCacheTest : public testing::Test
{
protected:
  ModelSoftness Soften(const SofteningSettings& settings) const
  {
    return SoftenModel(Ball(), "ball", settings, GoOn, &this->Cache);
  }
  std::vector<fs::path> Files() const
  {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(this->Kept))
    {
      files.push_back(entry.path());
    }
    return files;
  }

  test::TemporaryFolder Folder;
  fs::path Kept = Folder / "kept" / "palpate";
  SofteningCache Cache{Kept};
};

TEST_F(SofteningCacheTest, SecondTimeIsReadAndEqualInEveryBit)
{
  const ModelSoftness made = this->Soften(Quick());
  EXPECT_FALSE(made.IsFromCache);
  const ModelSoftness again = this->Soften(Quick());
  EXPECT_TRUE(again.IsFromCache);
  EXPECT_EQ(again.Elasticity->Coefficients, made.Elasticity->Coefficients);
  EXPECT_EQ(again.Elasticity->LargestPatch, made.Elasticity->LargestPatch);
  EXPECT_EQ(again.Elasticity->PoissonRatio, made.Elasticity->PoissonRatio);
  EXPECT_EQ(again.Elasticity->LongWaves.Roots, made.Elasticity->LongWaves.Roots);
  EXPECT_EQ(again.Elasticity->LongWaves.Relative, made.Elasticity->LongWaves.Relative);
  EXPECT_EQ(again.Elasticity->FitError.Rms, made.Elasticity->FitError.Rms);
  EXPECT_EQ(again.Account.Unknowns, made.Account.Unknowns);
  EXPECT_EQ(again.Account.ElementEdge, made.Account.ElementEdge);
  EXPECT_EQ(again.Tissue, made.Tissue);
  EXPECT_FALSE(this->Soften(Quick(21.0)).IsFromCache);
}

TEST_F(SofteningCacheTest, OnlyTheUserCanReadIt)
{
  this->Soften(Quick());
  ASSERT_EQ(this->Files().size(), 1U);
  EXPECT_EQ(ModeOf(this->Files().front()), 0600U);
  EXPECT_EQ(ModeOf(this->Kept), 0700U);
}

TEST_F(SofteningCacheTest, FolderThatOthersWriteToIsNotUsed)
{
  this->Soften(Quick());
  for (const fs::perms others : {fs::perms::group_write, fs::perms::others_write})
  {
    fs::permissions(this->Kept, fs::perms::owner_all | others);
    EXPECT_FALSE(this->Soften(Quick()).IsFromCache);
  }
  fs::permissions(this->Kept, fs::perms::owner_all);
  EXPECT_TRUE(this->Soften(Quick()).IsFromCache);
}

TEST_F(SofteningCacheTest, BadFilesAreMadeAgain)
{
  this->Soften(Quick());
  const fs::path file = this->Files().front();
  const std::string good = ReadWholeFile(file, 1 << 24);
  const auto with = [&good](const std::string& a, const std::string& b)
  {
    std::string text = good;
    const std::size_t at = text.find(a);
    EXPECT_NE(at, std::string::npos) << a;
    return text.replace(at, a.size(), b);
  };
  const std::string key = file.stem().string().substr(10);
  const std::vector<std::string> bad{"",
                                     "{",
                                     std::string(100000, '['),
                                     good.substr(0, good.size() / 2),
                                     with(key, std::string(32, '0')),
                                     with("\"largest_patch_mm\": ", "\"largest_patch_mm\": -"),
                                     with("\"elasticity\"", "\"other\""),
                                     with("\"unknowns\": \"", "\"unknowns\": \"-"),
                                     with("\"element_edge_mm\": \"", "\"element_edge_mm\": \"x")};
  for (const std::string& text : bad)
  {
    std::ofstream(file, std::ios::binary) << text;
    EXPECT_FALSE(this->Soften(Quick()).IsFromCache) << text.substr(0, 80);
    EXPECT_TRUE(this->Soften(Quick()).IsFromCache) << "it is replaced";
  }
  const fs::path elsewhere = this->Folder / "elsewhere";
  fs::rename(file, elsewhere);
  fs::create_symlink(elsewhere, file);
  EXPECT_FALSE(this->Soften(Quick()).IsFromCache) << "links are not followed";
  EXPECT_TRUE(this->Soften(Quick()).IsFromCache);
  EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(file)));
}

TEST_F(SofteningCacheTest, AnotherModelUnderTheSameKeyIsNotTaken)
{
  const ModelSoftness made = this->Soften(Quick());
  const SofteningCache::Entry entry{made.Elasticity, made.Account};
  this->Cache.Store("a", Ball(), entry);
  EXPECT_TRUE(this->Cache.Find("a", Ball()).has_value());
  EXPECT_FALSE(this->Cache.Find("a", Ball(15.0)).has_value());
  EXPECT_FALSE(this->Cache.Find("b", Ball()).has_value());
}

TEST_F(SofteningCacheTest, LeastRecentlyUsedAreRemoved)
{
  const ModelSoftness made = this->Soften(Quick());
  const std::uintmax_t bytes = fs::file_size(this->Files().front());
  const fs::path folder = this->Folder / "small";
  const SofteningCache small(folder, 3 * bytes);
  const SofteningCache::Entry entry{made.Elasticity, made.Account};
  const auto age = [&](const std::string& key, int hours)
  {
    fs::last_write_time(folder / ("softening-" + key + ".json"),
                        fs::file_time_type::clock::now() - std::chrono::hours(hours));
  };
  const auto has = [&](const std::string& key) { return small.Find(key, Ball()).has_value(); };
  for (const char* key : {"1", "2", "3"})
  {
    small.Store(key, Ball(), entry);
  }
  ASSERT_TRUE(fs::exists(folder / "softening-3.json"));
  age("1", 3);
  age("2", 2);
  age("3", 1);
  WriteWholeFile(folder / "notes.txt", "of the user");
  EXPECT_TRUE(has("1")) << "which makes it the last used";
  small.Store("4", Ball(), entry);
  EXPECT_FALSE(has("2"));
  EXPECT_TRUE(has("1") && has("3") && has("4"));
  EXPECT_TRUE(fs::exists(folder / "notes.txt"));
}

TEST_F(SofteningCacheTest, FolderThatCannotBeMadeIsNoCache)
{
  WriteWholeFile(this->Folder / "file", "x");
  const SofteningCache cache(this->Folder / "file" / "below");
  const ModelSoftness made = SoftenModel(Ball(), "ball", Quick(), GoOn, &cache);
  EXPECT_NE(made.Elasticity, nullptr);
  EXPECT_FALSE(SoftenModel(Ball(), "ball", Quick(), GoOn, &cache).IsFromCache);
}

TEST_F(SofteningCacheTest, ProcessHasNoneUnlessAnApplicationChoosesOne)
{
  EXPECT_EQ(SofteningCache::OfProcess(), nullptr);
  SofteningCache::UseInProcess(this->Kept);
  EXPECT_NE(SofteningCache::OfProcess(), nullptr);
  SofteningCache::UseInProcess({});
  EXPECT_EQ(SofteningCache::OfProcess(), nullptr);
}

TEST(SofteningCacheFolder, IsTheUsersUnlessChosen)
{
  const ChangedVariables restored({"PALPATE_CACHE_DIR", "XDG_CACHE_HOME", "HOME"});
  setenv("HOME", "/home/someone", 1);
  setenv("XDG_CACHE_HOME", "/some/cache", 1);
  setenv("PALPATE_CACHE_DIR", "chosen", 1);
  EXPECT_EQ(SofteningCache::UserFolder(), "chosen");
  setenv("PALPATE_CACHE_DIR", "", 1);
  EXPECT_EQ(SofteningCache::UserFolder(), "") << "none";
  unsetenv("PALPATE_CACHE_DIR");
  EXPECT_EQ(SofteningCache::UserFolder(), "/some/cache/palpate");
  setenv("XDG_CACHE_HOME", "relative", 1);
  EXPECT_EQ(SofteningCache::UserFolder(), "/home/someone/.cache/palpate");
  unsetenv("HOME");
  EXPECT_EQ(SofteningCache::UserFolder(), "");
}

TEST(SofteningKey, DiffersWithEveryInput)
{
  const std::vector<std::function<void(SofteningSettings&)>> changes{
      [](SofteningSettings&) {},
      [](SofteningSettings& s) { s.TissueKilopascal = 21.0; },
      [](SofteningSettings& s) { s.PoissonRatio = 0.4; },
      [](SofteningSettings& s) { s.Exaggeration = 2.0; },
      [](SofteningSettings& s) { s.BedPerMillimeter = 2.0; },
      [](SofteningSettings& s) { s.FreeDegrees = 50.0; },
      [](SofteningSettings& s) { s.FreeSides = {Vector3::UnitX()}; },
      [](SofteningSettings& s) { s.FreeSides = {Vector3::UnitY()}; },
      [](SofteningSettings& s) { s.Numbers.ElementsAcross = 6; },
      [](SofteningSettings& s) { s.Numbers.Degree = 5; },
      [](SofteningSettings& s) { s.Numbers.Maps.Degree = 7; },
      [](SofteningSettings& s) { s.Numbers.Maps.LargestPatch = 4.0; }};
  std::set<std::string> keys{SofteningKey(Ball(15.0), Quick()).Text()};
  const RadialModel moved(0, Ball().Coefficients(), Vector3::UnitX());
  keys.insert(SofteningKey(moved, Quick()).Text());
  for (const auto& change : changes)
  {
    SofteningSettings settings = Quick();
    change(settings);
    keys.insert(SofteningKey(Ball(), settings).Text());
  }
  TissueMap::Samples samples;
  samples.Grid = FieldGrid({{2, 2, 2}}, Vector3::Zero(), Vector3::Ones(), Matrix3::Identity());
  samples.Values.assign(8, 1.0F);
  TissueMap::Samples shifted = samples;
  shifted.Grid = FieldGrid({{2, 2, 2}}, Vector3::UnitZ(), Vector3::Ones(), Matrix3::Identity());
  TissueMap::Samples other = samples;
  other.Values.back() = 0.0F;
  for (const TissueMap::Samples& one : {samples, shifted, other})
  {
    SofteningKey key(Ball(), Quick());
    key.Add("inclusion", one, 60.0);
    keys.insert(key.Text());
  }
  SofteningKey harder(Ball(), Quick());
  harder.Add("inclusion", samples, 80.0);
  keys.insert(harder.Text());
  SofteningKey held(Ball(), Quick());
  held.Add("neighbour", samples, 60.0);
  keys.insert(held.Text());
  EXPECT_EQ(keys.size(), changes.size() + 7U);
  EXPECT_EQ(SofteningKey(Ball(), Quick()).Text(), SofteningKey(Ball(), Quick()).Text());
  EXPECT_EQ(keys.begin()->size(), 32U);
}
} // namespace
} // namespace palpate::softening_cache_test

#include "SoundingDevice.h"

#include "DeviceContract.h"
#include "ManualClock.h"
#include "SimulatedDevice.h"
#include "TemporaryFolder.h"
#include "TouchState.h"

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>
#include <vector>

namespace palpate::sounding_device_test
{
namespace
{
/// SDL's output into a file (SDL_AUDIODRIVER=disk): what a loudspeaker would get.
class SoundingDeviceTest : public testing::Test
{
protected:
  void SetUp() override
  {
    std::shared_ptr<const SdlLibrary> sdl;
    if (!SdlLibrary::Load(sdl).IsOk())
    {
      GTEST_SKIP() << "without SDL 2";
    }
    setenv("SDL_AUDIODRIVER", "disk", 1);
    setenv("SDL_DISKAUDIOFILE", this->File.c_str(), 1);
    setenv("SDL_DISKAUDIODELAY", "1", 1);
  }
  void TearDown() override
  {
    unsetenv("SDL_AUDIODRIVER");
    unsetenv("SDL_DISKAUDIOFILE");
    unsetenv("SDL_DISKAUDIODELAY");
  }
  /// Waits until so many more bytes were played, some seconds at most.
  void Play(std::uintmax_t bytes)
  {
    const auto played = [this]
    {
      std::error_code ignored;
      const auto size = std::filesystem::file_size(this->File, ignored);
      return ignored ? 0 : size;
    };
    const std::uintmax_t before = played();
    for (int n = 0; n < 5000 && played() < before + bytes; ++n)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  std::vector<float> Heard() const
  {
    std::ifstream file(this->File, std::ios::binary);
    std::vector<float> samples(std::filesystem::file_size(this->File) / sizeof(float));
    file.read(reinterpret_cast<char*>(samples.data()),
              static_cast<std::streamsize>(samples.size() * sizeof(float)));
    return samples;
  }

  test::TemporaryFolder Folder;
  std::string File = (Folder / "sound.raw").string();
  ManualClock Time{1'000'000};
  SoundingDevice Device{std::make_unique<SimulatedDevice>(this->Time, SimulatedSettings())};
};

TEST_F(SoundingDeviceTest, KeepsTheContractOfTheDeviceThatIsHeard)
{
  test::ExpectDeviceContract(this->Device, [this] { this->Time.Advance(1'000'000); });
}

TEST_F(SoundingDeviceTest, ForceIsHeardAndItsEndIsSilence)
{
  ASSERT_TRUE(this->Device.Open().IsOk());
  TouchState touched;
  touched.Structure = 0;
  touched.ForceDevice = Vector3(0.0, 0.0, 2.0);
  touched.Depth = 1.0;
  this->Device.Show(touched);
  this->Play(64 * 1024);
  const std::size_t loud = this->Heard().size();
  this->Device.Show(TouchState());
  this->Play(128 * 1024);
  this->Device.Close();
  const std::vector<float> heard = this->Heard();
  ASSERT_GT(heard.size(), loud);
  float loudest = 0.0F;
  for (std::size_t n = 0; n < loud; ++n)
  {
    loudest = std::max(loudest, std::abs(heard[n]));
  }
  EXPECT_GT(loudest, 0.1F);
  EXPECT_LT(std::abs(heard.back()), 1e-4F);
}

TEST_F(SoundingDeviceTest, WithoutAnOutputItIsNotOpened)
{
  setenv("SDL_AUDIODRIVER", "none-of-these", 1);
  EXPECT_NE(this->Device.Open().Message().find("no sound output"), std::string::npos);
  EXPECT_EQ(this->Device.State(), DeviceState::Closed);
}
} // namespace
} // namespace palpate::sounding_device_test

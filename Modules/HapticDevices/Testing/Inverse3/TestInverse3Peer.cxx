#include "Inverse3Device.h"
#include "SteadyClock.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <thread>

namespace palpate::inverse3_peer_test
{
namespace
{
/// A service in another language, by another library.
class PythonPeer
{
public:
  static bool IsAvailable()
  {
    return std::system("/usr/bin/python3 -c 'import websockets' 2>/dev/null") == 0;
  }
  PythonPeer()
  {
    // The shell tells its number, which is then the service's.
    this->Output = popen("echo $$; exec /usr/bin/python3 " PALPATE_INVERSE3_PEER, "r");
    this->Process = std::stoi(this->Line());
    const std::string ports = this->Line();
    this->Argument =
        "port=" + ports.substr(0, ports.find(' ')) + ",events=" + ports.substr(ports.find(' ') + 1);
  }
  ~PythonPeer()
  {
    kill(this->Process, SIGKILL);
    pclose(this->Output);
  }
  std::string Line()
  {
    char line[256] = "";
    EXPECT_NE(std::fgets(line, sizeof(line), this->Output), nullptr);
    const std::string text = line;
    return text.substr(0, text.find('\n'));
  }

  std::string Argument;

private:
  FILE* Output = nullptr;
  int Process = 0;
};

TEST(Inverse3Peer, AnotherLibraryReadsForcesAndAnswersEachTick)
{
  if (!PythonPeer::IsAvailable())
  {
    GTEST_SKIP() << "without python3-websockets";
  }
  PythonPeer peer;
  SteadyClock time;
  DeviceRegistry registry;
  ASSERT_TRUE(RegisterInverse3Devices(registry).IsOk());
  std::unique_ptr<HapticDevice> device;
  ASSERT_TRUE(registry.Make("inverse3:" + peer.Argument, time, device).IsOk());
  ASSERT_TRUE(device->Open().IsOk());
  DeviceSample sample;
  std::uint64_t first = 0;
  int ticks = 0;
  for (int n = 0; n < 5000 && ticks < 500; ++n)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    device->Read(sample);
    device->Apply({0.0, 0.0, 2.0});
    const bool isReady = device->State() == DeviceState::Ready;
    first = isReady && ticks == 0 ? sample.Sequence : first;
    ticks += isReady ? 1 : 0;
  }
  EXPECT_EQ(ticks, 500) << device->Problem();
  EXPECT_LT((Vector3(sample.Position) - Vector3(1.0, 3.0, -2.0)).norm(), 1e-9);
  // A busy machine delays some replies by a tick.
  EXPECT_GT(sample.Sequence - first, 250u);
  RecordProperty("report", device->ConnectionReport());
  device->Close();
  int messages = 0;
  double largest = 0.0;
  int refused = -1;
  double last[3] = {1.0, 1.0, 1.0};
  const std::string told = peer.Line();
  ASSERT_EQ(std::sscanf(told.c_str(), "%d %lf %d %lf %lf %lf", &messages, &largest, &refused, last,
                        last + 1, last + 2),
            6)
      << told;
  EXPECT_GT(messages, 250);
  EXPECT_EQ(refused, 0);
  EXPECT_NEAR(largest, 2.0, 1e-3);
  EXPECT_EQ(std::abs(last[0]) + std::abs(last[1]) + std::abs(last[2]), 0.0) << "0 N at the end";
}
} // namespace
} // namespace palpate::inverse3_peer_test

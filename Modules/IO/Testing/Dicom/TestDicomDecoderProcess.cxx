#include "ChildProgram.h"
#include "FrameExchange.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>
#include <string>
#include <unistd.h>
#include <vector>

namespace palpate::dicom_decoder_process_test
{
namespace
{
// Runs palpate-dicom-decoder and uses the protocol of DicomFrameDecoder.
class DecoderProcess : public testing::Test
{
protected:
  void SetUp() override
  {
    int sockets[2] = {-1, -1};
    ASSERT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets), 0);
    this->Socket = sockets[0];
    this->Process = StartChildProgram("palpate-dicom-decoder", {}, sockets[1]);
    close(sockets[1]);
    ASSERT_GT(this->Process, 0);
  }

  void TearDown() override
  {
    close(this->Socket);
    WaitForChildProgram(this->Process);
  }

  // Empty if the process ended instead.
  std::vector<std::uint8_t> Answer(const FrameRequest& request,
                                   const std::vector<std::uint8_t>& stream) const
  {
    std::vector<std::uint8_t> samples(request.SampleBytes());
    const bool isAnswered = SendAll(this->Socket, &request, sizeof(request)) &&
                            SendAll(this->Socket, stream.data(), stream.size()) &&
                            ReceiveAll(this->Socket, samples.data(), samples.size());
    return isAnswered ? samples : std::vector<std::uint8_t>{};
  }

  // A row of four pixels, run-length coded: three literals, then the last one again.
  static FrameRequest Request() { return {FrameRequest::Codec::RunLength, 4, 1, 1, 8, 70}; }
  static std::vector<std::uint8_t> Stream()
  {
    std::vector<std::uint8_t> stream(70, 0);
    stream[0] = 1;
    stream[4] = 64;
    const std::array<std::uint8_t, 6> coded{2, 1, 2, 3, 0, 3};
    std::copy(coded.begin(), coded.end(), stream.begin() + 64);
    return stream;
  }

  std::filesystem::path Proc(const char* name) const
  {
    return std::filesystem::path("/proc") / std::to_string(this->Process) / name;
  }

  double PeakMappedBytes() const
  {
    std::ifstream status(this->Proc("status"));
    std::string line;
    while (std::getline(status, line))
    {
      if (line.rfind("VmPeak:", 0) == 0)
      {
        return std::stod(line.substr(7)) * 1024.0;
      }
    }
    return 0.0;
  }

  // The soft limit's word in /proc/PID/limits.
  std::string Limit(const std::string& name) const
  {
    std::ifstream limits(this->Proc("limits"));
    std::string line;
    while (std::getline(limits, line))
    {
      if (line.rfind(name, 0) == 0)
      {
        std::istringstream rest(line.substr(name.size()));
        std::string word;
        rest >> word;
        return word;
      }
    }
    return "absent";
  }

  int Socket = -1;
  pid_t Process = -1;
};

TEST_F(DecoderProcess, InheritsNoFiles)
{
  // Before the process starts, opens a file that exec does not close.
  this->TearDown();
  const int open = dup(STDERR_FILENO);
  this->SetUp();
  EXPECT_EQ(this->Answer(Request(), Stream()), (std::vector<std::uint8_t>{1, 2, 3, 3}));
  for (const auto& entry : std::filesystem::directory_iterator(this->Proc("fd")))
  {
    const std::string name = entry.path().filename();
    EXPECT_TRUE(name == "0" || name == "1" || name == "2")
        << name << ": " << std::filesystem::read_symlink(entry.path());
  }
  close(open);
}

TEST_F(DecoderProcess, LimitsFollowFromTheFrame)
{
  ASSERT_FALSE(this->Answer(Request(), Stream()).empty());
  // 64 MB for a small frame, on top of what was mapped then: sanitizers map terabytes, which they
  // may have given back since.
  EXPECT_LE(std::stod(this->Limit("Max address space")), this->PeakMappedBytes() + 80e6);
  EXPECT_LE(std::stod(this->Limit("Max cpu time")), 7.0);
  EXPECT_EQ(this->Limit("Max core file size"), "0");
}

TEST_F(DecoderProcess, EndsWithItsClient)
{
  close(this->Socket);
  WaitForChildProgram(this->Process); // otherwise waits forever
  this->SetUp();
}

TEST(ChildProgram, ReportsMissingProgram)
{
  EXPECT_EQ(StartChildProgram("palpate-no-such-program", {}, STDIN_FILENO), -1);
}
} // namespace
} // namespace palpate::dicom_decoder_process_test

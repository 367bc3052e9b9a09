#include "VirtualFalconBoard.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate::test
{
namespace
{
constexpr double GreetingBaud = 9600.0;
constexpr double RunBaud = 1.5e6;
constexpr std::int64_t ReadyDelay = 1'000'000; // ns, from greeted to CTS
constexpr std::int64_t StartDelay = 5'000'000; // ns, from the last byte to running
constexpr std::int64_t AnswerDelay = 20'000;   // ns, of a packet
constexpr std::uint64_t HeadWords = 11;        // key, eight reserved, entry of two
constexpr std::size_t PacketBytes = 16;

std::int16_t Decoded(const std::vector<std::uint8_t>& frame, std::size_t first)
{
  unsigned value = 0;
  for (std::size_t i = 0; i < 4; ++i)
  {
    value |= ((frame[first + i] - 0x41U) & 0xFU) << (4 * i);
  }
  return static_cast<std::int16_t>(static_cast<std::uint16_t>(value));
}

void Encode(std::int16_t number, std::vector<std::uint8_t>& frame)
{
  const auto value = static_cast<std::uint16_t>(number);
  for (unsigned shift = 0; shift < 16; shift += 4)
  {
    frame.push_back(static_cast<std::uint8_t>(0x41U + (value >> shift & 0xFU)));
  }
}

bool IsLetter(std::uint8_t byte)
{
  return byte >= 0x41 && byte <= 0x50;
}
} // namespace

void VirtualFalconBoard::PowerOff()
{
  *this = [this]
  {
    VirtualFalconBoard off;
    off.ResetCount = this->ResetCount + 1;
    off.PacketCount = this->PacketCount;
    off.Dtr = this->Dtr;
    off.Orders = std::move(this->Orders);
    return off;
  }();
}

void VirtualFalconBoard::SetDataTerminalReady(bool level, std::int64_t now, VirtualFtdiChip& chip)
{
  if (level && !this->Dtr)
  {
    this->PowerOff();
    this->Life = State::Greeting;
    this->Time = now;
    chip.SetClearToSend(false, now);
  }
  this->Dtr = level;
  if (!level && this->Life == State::Greeting && this->Numbers[0] > 0)
  {
    this->Life = State::BaudLock;
    this->RaiseClearToSend = now + ReadyDelay;
  }
}

std::int64_t VirtualFalconBoard::NextEvent() const
{
  return std::min({this->RaiseClearToSend, this->Start, this->Lapse});
}

void VirtualFalconBoard::Advance(std::int64_t now, VirtualFtdiChip& chip,
                                 VirtualMechanism& mechanism, const VirtualFalconFaults& faults)
{
  if (this->RaiseClearToSend <= now)
  {
    if (faults.RaisesClearToSend && faults.HasSupply)
    {
      chip.SetClearToSend(true, this->RaiseClearToSend);
    }
    this->RaiseClearToSend = VirtualFtdiChip::Never;
  }
  if (this->Start <= now)
  {
    this->Life = faults.StartsFirmware ? State::Running : State::Off;
    this->Frame.clear();
    this->Start = VirtualFtdiChip::Never;
  }
  if (this->Lapse <= now)
  {
    mechanism.SetMotors({});
    this->Lapse = VirtualFtdiChip::Never;
  }
}

void VirtualFalconBoard::Receive(const VirtualFtdiChip::WireByte& byte, VirtualFtdiChip& chip,
                                 VirtualMechanism& mechanism, const VirtualFalconFaults& faults)
{
  this->Time = byte.Time;
  if (!faults.HasSupply)
  {
    return;
  }
  const double own = this->Life == State::Greeting  ? GreetingBaud
                     : this->Life == State::Running ? RunBaud
                                                    : this->Baud;
  const bool isHeard = VirtualFtdiChip::Matches(byte.Baud, own);
  if (this->Life == State::BaudLock)
  {
    this->Lock(byte, chip, faults);
  }
  else if (isHeard && this->Life == State::Greeting)
  {
    this->Greet(byte.Value, chip, faults);
  }
  else if (isHeard && this->Life == State::Loading)
  {
    this->Load(byte.Value, chip, faults);
  }
  else if (isHeard && this->Life == State::Running)
  {
    this->Run(byte.Value, chip, mechanism, faults);
  }
}

void VirtualFalconBoard::Answer(VirtualFalconAnswer::Kind kind, std::vector<std::uint8_t> bytes,
                                std::int64_t delay, VirtualFtdiChip& chip,
                                const VirtualFalconFaults& faults)
{
  VirtualFalconAnswer answer;
  answer.What = kind;
  answer.Number = this->Numbers[static_cast<std::size_t>(kind)]++;
  answer.Resets = this->ResetCount;
  answer.Bytes = std::move(bytes);
  answer.Delay = delay;
  if (faults.Spoil != nullptr)
  {
    faults.Spoil(answer);
  }
  this->Unplugs = this->Unplugs || answer.Unplugs;
  const std::int64_t duration = std::llround(1e10 / this->Baud);
  this->WireFree = std::max(this->WireFree, this->Time + answer.Delay);
  for (const std::uint8_t value : answer.Bytes)
  {
    this->WireFree += duration;
    chip.Receive({this->WireFree, this->Baud, value});
    this->WireFree += answer.Gap;
  }
}

void VirtualFalconBoard::Greet(std::uint8_t value, VirtualFtdiChip& chip,
                               const VirtualFalconFaults& faults)
{
  this->Baud = GreetingBaud;
  this->Frame.push_back(value);
  if (this->Frame.size() > 3)
  {
    this->Frame.erase(this->Frame.begin());
  }
  if (this->Frame == std::vector<std::uint8_t>{0x0A, 0x43, 0x0D})
  {
    this->Frame.clear();
    this->Answer(VirtualFalconAnswer::Kind::Greeting, {0x0A, 0x44, 0x2C, 0x0D}, 0, chip, faults);
  }
}

void VirtualFalconBoard::Lock(const VirtualFtdiChip::WireByte& byte, VirtualFtdiChip& chip,
                              const VirtualFalconFaults& faults)
{
  if (byte.Value == 0x41 && byte.Baud <= faults.FastestUpload)
  {
    this->Baud = byte.Baud;
    this->Life = State::Loading;
    this->Part = 0;
    this->WordsLeft = HeadWords;
    this->Answer(VirtualFalconAnswer::Kind::BaudLock, {0x41}, 0, chip, faults);
  }
}

void VirtualFalconBoard::Load(std::uint8_t value, VirtualFtdiChip& chip,
                              const VirtualFalconFaults& faults)
{
  this->Loaded.push_back(value);
  this->Answer(VirtualFalconAnswer::Kind::Echo, {value}, 0, chip, faults);
  const std::size_t size = this->Loaded.size();
  if (size % 2 == 0)
  {
    this->TakeWord(this->Loaded[size - 2] | static_cast<unsigned>(this->Loaded[size - 1]) << 8U);
  }
}

// Words are little endian; a block is its size, an address of two words, and its words.
void VirtualFalconBoard::TakeWord(unsigned word)
{
  if (this->Part == 0 && this->WordsLeft == HeadWords && word != 0x08AA)
  {
    this->Life = State::Off;
  }
  if (this->Part == 1)
  {
    this->Part = 2;
    this->WordsLeft = 2 + static_cast<std::uint64_t>(word);
    if (word == 0)
    {
      this->Start = this->Time + StartDelay;
      this->Life = State::Off;
    }
    return;
  }
  if (--this->WordsLeft == 0)
  {
    this->Part = 1;
  }
}

void VirtualFalconBoard::Run(std::uint8_t value, VirtualFtdiChip& chip, VirtualMechanism& mechanism,
                             const VirtualFalconFaults& faults)
{
  this->Baud = RunBaud;
  if (value == '<' || this->Frame.empty())
  {
    this->BadPacketCount += this->Frame.empty() ? 0 : 1;
    this->Frame.clear();
    if (value != '<')
    {
      return;
    }
  }
  this->Frame.push_back(value);
  if (this->Frame.size() == PacketBytes)
  {
    const bool isGood =
        value == '>' && std::all_of(this->Frame.begin() + 1, this->Frame.end() - 1, IsLetter);
    this->BadPacketCount += isGood ? 0 : 1;
    if (isGood)
    {
      this->Obey(chip, mechanism, faults);
    }
    this->Frame.clear();
  }
}

void VirtualFalconBoard::Obey(VirtualFtdiChip& chip, VirtualMechanism& mechanism,
                              const VirtualFalconFaults& faults)
{
  ++this->PacketCount;
  this->Commanded = {Decoded(this->Frame, 1), Decoded(this->Frame, 5), Decoded(this->Frame, 9)};
  this->Asked = this->Frame[13] - 0x41U;
  mechanism.SetMotors(this->Commanded);
  mechanism.SetHoming((this->Asked & 1U) != 0);
  this->Orders.push_back({this->Time, this->Commanded});
  this->Lapse = faults.TorqueLapse == VirtualFtdiChip::Never ? VirtualFtdiChip::Never
                                                             : this->Time + faults.TorqueLapse;

  std::vector<std::uint8_t> reply{'<'};
  for (const std::int16_t count : mechanism.Counters())
  {
    Encode(count, reply);
  }
  const unsigned homed = (this->Asked & 1U) != 0 ? mechanism.HomedBits() : 0U;
  reply.push_back(static_cast<std::uint8_t>(0x41U + (homed << 4U) + mechanism.Settings.Buttons));
  reply.push_back(0x41);
  reply.push_back('>');
  this->Answer(VirtualFalconAnswer::Kind::Run, std::move(reply), AnswerDelay, chip, faults);
}
} // namespace palpate::test

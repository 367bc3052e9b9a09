#include "Inverse3Client.h"

#include "Inverse3Messages.h"
#include "TextSocket.h"

#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/steady_timer.hpp>
#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <thread>

namespace palpate
{
namespace
{
namespace asio = boost::asio;
using Failed = boost::system::error_code;

constexpr std::chrono::milliseconds LongestStart(2000);
constexpr std::chrono::milliseconds LongestStop(50);
constexpr std::chrono::milliseconds WatchPeriod(2);
constexpr std::int64_t ForceLasts = 20'000'000;       // ns without Apply
constexpr std::int64_t ReplyIsOverdue = 5'000'000;    // ns
constexpr std::int64_t ServiceIsGone = 1'000'000'000; // ns without a reply
constexpr int MostIdle = 100;           // replies, before the other field's name is tried
constexpr double FarFromMiddle = 150.0; // mm; no preset moved the origin to the middle of the reach
} // namespace

class Inverse3Client::Session
{
public:
  Session(Clock& clock, Inverse3Address address, Inverse3Exchange& exchange);
  ~Session() { this->Stop(); }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  Status Start();
  void Stop() noexcept;
  void Wake() noexcept;
  bool IsSmall() const noexcept { return this->Device.IsSmall; }

private:
  void Receive(std::string_view text);
  void Begin(const Inverse3Frame& frame);
  void TakeReply(const Inverse3Frame& frame);
  void JudgeMode(const Inverse3Frame& frame);
  void Publish(const Inverse3Frame& frame);
  void Send();
  void SendForce(const Vector3& force);
  void WaitForWake();
  void WaitForWatch();
  void Watch();
  void End(const std::string& reason);
  void Run() noexcept;
  std::int64_t SinceSent() const noexcept { return this->Time.Now() - this->SentAt; }

  Clock& Time;
  Inverse3Address Address;
  Inverse3Exchange& Shared;
  asio::io_context Context;
  TextSocket States;
  TextSocket Events;
  asio::posix::stream_descriptor Woken;
  asio::steady_timer Timer;
  std::thread Thread;
  std::string StartProblem;
  Inverse3Frame Device; // of the first message
  bool HasBegun = false;
  bool IsEnding = false;
  bool AsVector = false;
  bool HasChangedField = false;
  bool IsAccepted = false; // the device left its idle mode
  int IdleReplies = 0;
  int Awaited = 0; // replies
  std::uint64_t SentNumber = 0;
  std::int64_t SentAt = 0;
  Vector3 Sent = Vector3::Zero(); // N
  bool HasSent = false;
  std::optional<Vector3> Middle; // mm
  DeviceSample Last;
};

Inverse3Client::Session::Session(Clock& clock, Inverse3Address address, Inverse3Exchange& exchange)
    : Time(clock), Address(std::move(address)), Shared(exchange),
      States(Context, {[] {}, [this](std::string_view text) { this->Receive(text); },
                       [this] { this->Send(); },
                       [this](const std::string& reason) {
                         this->End("The connection to Haply's service has ended (" + reason + ")");
                       }}),
      // Older services have no events: the states then have to do.
      Events(Context, {[] {},
                       [this](std::string_view text)
                       {
                         if (const auto alarm = Inverse3Alarm(text, this->Device.Id))
                         {
                           this->End(*alarm);
                         }
                       },
                       [] {}, [](const std::string&) {}}),
      Woken(Context, eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)), Timer(Context)
{
}

Status Inverse3Client::Session::Start()
{
  this->States.Connect(this->Address.Port);
  this->Events.Connect(this->Address.EventPort);
  const auto end = std::chrono::steady_clock::now() + LongestStart;
  while (!this->HasBegun && this->StartProblem.empty() && this->Context.run_one_until(end) > 0)
  {
  }
  if (!this->HasBegun)
  {
    const std::string at = " at port " + std::to_string(this->Address.Port);
    return Status::Failure(
        this->States.IsConnected()
            ? "Haply's service" + at + " names no such Inverse3: plug it in and switch it on."
            : "Haply's service does not answer" + at +
                  ": install the Haply Hub or the Inverse Service, and start it.");
  }
  this->WaitForWake();
  this->WaitForWatch();
  this->Thread = std::thread([this] { this->Run(); });
  return Status::Success();
}

void Inverse3Client::Session::Run() noexcept
{
  try
  {
    this->Context.run();
  }
  catch (const std::exception& problem)
  {
    this->End(problem.what());
  }
}

void Inverse3Client::Session::Stop() noexcept
{
  if (!this->Thread.joinable())
  {
    return;
  }
  asio::post(this->Context,
             [this]
             {
               this->IsEnding = true;
               this->Send();
               this->Timer.expires_after(LongestStop);
               this->Timer.async_wait([this](const Failed&) { this->Context.stop(); });
             });
  this->Thread.join();
  this->States.Close();
  this->Events.Close();
}

void Inverse3Client::Session::Wake() noexcept
{
  const std::uint64_t one = 1;
  // Full only if the thread was woken before and has not run since.
  static_cast<void>(!write(this->Woken.native_handle(), &one, sizeof(one)));
}

void Inverse3Client::Session::WaitForWake()
{
  this->Woken.async_wait(asio::posix::stream_descriptor::wait_read,
                         [this](const Failed& failed)
                         {
                           if (failed)
                           {
                             return;
                           }
                           std::uint64_t count = 0;
                           static_cast<void>(
                               !read(this->Woken.native_handle(), &count, sizeof(count)));
                           this->Send();
                           this->WaitForWake();
                         });
}

void Inverse3Client::Session::WaitForWatch()
{
  this->Timer.expires_after(WatchPeriod);
  this->Timer.async_wait(
      [this](const Failed& failed)
      {
        if (!failed && !this->IsEnding)
        {
          this->Watch();
          this->WaitForWatch();
        }
      });
}

// A force that lapsed, a reply that is overdue, a service that is gone.
void Inverse3Client::Session::Watch()
{
  this->Shared.IsBehind = this->Awaited > 0 && this->SinceSent() > ReplyIsOverdue;
  if (this->Awaited > 0 && this->SinceSent() > ServiceIsGone)
  {
    this->End("Haply's service does not answer any more");
  }
  this->Send();
}

void Inverse3Client::Session::Receive(std::string_view text)
{
  const auto frame = ReadInverse3Frame(text, this->HasBegun ? this->Device.Id : this->Address.Id);
  if (!frame)
  {
    this->End("Haply's service sends no state of " +
              (this->HasBegun ? "the Inverse3 " + this->Device.Id : "such an Inverse3"));
    return;
  }
  if (!this->HasBegun)
  {
    this->Begin(*frame);
    return;
  }
  this->TakeReply(*frame);
  this->Send();
}

void Inverse3Client::Session::Begin(const Inverse3Frame& frame)
{
  this->Device = frame;
  this->AsVector = frame.HasPresets;
  this->HasBegun = true;
  this->Last = {};
  this->SendForce(Vector3::Zero());
}

void Inverse3Client::Session::TakeReply(const Inverse3Frame& frame)
{
  const std::int64_t taken = this->SinceSent();
  this->Awaited = std::max(0, this->Awaited - 1);
  this->Shared.IsBehind = this->Awaited > 0;
  this->Shared.Replies.fetch_add(1);
  this->Shared.SumOfReplies.fetch_add(taken);
  this->Shared.LongestReply = std::max(this->Shared.LongestReply.load(), taken);
  const double difference = (frame.Displayed - this->Sent).norm();
  this->Shared.LargestDifference = std::max(this->Shared.LargestDifference.load(), difference);
  this->JudgeMode(frame);
  if (frame.Position)
  {
    this->Publish(frame);
  }
}

// A service that does not know the name of the force's field leaves the device idle.
void Inverse3Client::Session::JudgeMode(const Inverse3Frame& frame)
{
  this->IsAccepted = this->IsAccepted || !frame.IsIdle;
  this->IdleReplies = frame.IsIdle ? this->IdleReplies + 1 : 0;
  if (this->IdleReplies < MostIdle)
  {
    return;
  }
  this->IdleReplies = 0;
  if (this->IsAccepted || this->HasChangedField)
  {
    this->End("Haply's service takes no forces: the device stays idle");
    return;
  }
  this->HasChangedField = true;
  this->AsVector = !this->AsVector;
}

// Not a number is published too: the servo's watchdog judges it.
void Inverse3Client::Session::Publish(const Inverse3Frame& frame)
{
  if (!this->Middle)
  {
    const bool isCentered = frame.Position->norm() < FarFromMiddle;
    this->Middle = this->Device.HasPresets && isCentered ? Vector3::Zero() : *frame.Position;
  }
  this->Last.Position = Vector3(*frame.Position - *this->Middle);
  if (frame.Orientation)
  {
    Eigen::Map<Eigen::Vector4d>(this->Last.Orientation.data()) = frame.Orientation->coeffs();
  }
  this->Last.Buttons = frame.Buttons;
  this->Last.Time = this->Time.Now();
  ++this->Last.Sequence;
  this->Shared.Newest.Publish(this->Last);
  DeviceState homing = DeviceState::Homing;
  if (this->IsAccepted)
  {
    this->Shared.Life.compare_exchange_strong(homing, DeviceState::Ready);
  }
}

void Inverse3Client::Session::Send()
{
  if (!this->HasBegun || !this->States.IsConnected())
  {
    return;
  }
  const auto& command = this->Shared.Wanted.Latest();
  const bool isOld = this->Time.Now() - command.Time > ForceLasts;
  const bool isNew = command.Number != this->SentNumber;
  const bool mustStop = this->IsEnding || isOld || this->Shared.Life != DeviceState::Ready;
  const Vector3 force = mustStop ? Vector3::Zero() : Vector3(command.Force);
  const bool ends = force.isZero(0.0) && !this->Sent.isZero(0.0);
  // While no servo asks, the connection is kept by messages that ask for the state.
  const bool isDue = isNew || (isOld && this->SinceSent() > ForceLasts / 4);
  if (ends || (isDue && this->Awaited == 0))
  {
    this->SentNumber = command.Number;
    this->SendForce(force);
  }
}

void Inverse3Client::Session::SendForce(const Vector3& force)
{
  if (this->States.Write(Inverse3ForceMessage(this->Device.Id, force, this->AsVector,
                                              !this->HasSent, this->Device.HasPresets)))
  {
    this->HasSent = true;
    this->Sent = force;
    this->SentAt = this->Time.Now();
    ++this->Awaited;
  }
}

// 0 N first, as far as it still goes.
void Inverse3Client::Session::End(const std::string& reason)
{
  if (!this->HasBegun)
  {
    this->StartProblem = reason;
    return;
  }
  if (this->IsEnding)
  {
    return;
  }
  this->Shared.SetProblem(reason);
  this->Shared.Life = DeviceState::Error;
  this->Send();
}

Inverse3Client::Inverse3Client(Clock& clock, Inverse3Address address, Inverse3Exchange& exchange)
    : Running(std::make_unique<Session>(clock, std::move(address), exchange))
{
}
Inverse3Client::~Inverse3Client() = default;
Status Inverse3Client::Start()
{
  return this->Running->Start();
}
void Inverse3Client::Stop() noexcept
{
  this->Running->Stop();
}
void Inverse3Client::Wake() noexcept
{
  this->Running->Wake();
}
bool Inverse3Client::IsSmall() const noexcept
{
  return this->Running->IsSmall();
}
} // namespace palpate

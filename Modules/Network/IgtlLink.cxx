#include "IgtlLink.h"

#include <chrono>
#include <new>
#include <utility>

namespace palpate
{
namespace
{
constexpr int LinkWaitMilliseconds = 10;
constexpr std::size_t LinkBytesAtOnce = 1 << 20;
constexpr std::size_t MostWaitingImages = 2;
constexpr std::size_t MostProblems = 16;
} // namespace

Status IgtlLink::Open(const IgtlPeer& peer)
{
  this->Close();
  const Status status = peer.Connects() ? this->Stream.Listen(peer.Port, peer.Host.empty())
                                        : this->Stream.Connect(peer.Host, peer.Port);
  if (!status.IsOk())
  {
    return status;
  }
  this->Peer = peer;
  this->MustEnd = false;
  this->IsOver = false;
  this->Thread = std::thread([this] { this->Run(); });
  return Status::Success();
}

void IgtlLink::Close() noexcept
{
  this->MustEnd = true;
  if (this->Thread.joinable())
  {
    this->Thread.join();
  }
  this->Stream.Close();
  this->Parser.reset();
  this->IsConnected = false;
}

void IgtlLink::Offer(std::vector<std::vector<std::uint8_t>> messages)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Offers = std::move(messages);
  this->NextOffer = 0;
  this->IsSent = false;
}

void IgtlLink::Show(const IgtlTouch& now)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Newest = now;
  this->IsNewestSent = false;
  this->IsSent = false;
}

void IgtlLink::EndTouch()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (this->Newest)
  {
    this->Newest->ForceWorld = PlainVector3();
    this->Newest->Structure = -1;
    this->Newest->Fault = "the touch has ended";
    this->IsNewestSent = false;
    this->IsSent = false;
  }
}

std::optional<IgtlImage> IgtlLink::TakeImage()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (this->Images.empty())
  {
    return std::nullopt;
  }
  IgtlImage image = std::move(this->Images.front());
  this->Images.pop_front();
  return image;
}

std::vector<std::string> IgtlLink::TakeProblems()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return std::exchange(this->Problems, {});
}

void IgtlLink::Run()
{
  this->Arrived.resize(LinkBytesAtOnce);
  while (!this->MustEnd && !this->IsOver)
  {
    this->Stream.Wait(LinkWaitMilliseconds);
    if (!this->Stream.HasPeer())
    {
      continue;
    }
    try
    {
      this->Exchange();
    }
    catch (const std::bad_alloc&)
    {
      this->EndPeer("There is not enough memory for what the peer sends, so the connection ends: "
                    "let it send smaller images.");
    }
  }
}

void IgtlLink::Exchange()
{
  if (!this->Parser)
  {
    this->BeginPeer();
  }
  if (this->IsFull())
  {
    // What the peer sent keeps Wait from waiting.
    std::this_thread::sleep_for(std::chrono::milliseconds(LinkWaitMilliseconds));
  }
  else if (!this->Receive())
  {
    return;
  }
  if (!this->Send())
  {
    this->EndPeer("The OpenIGTLink peer is gone.");
  }
}

void IgtlLink::BeginPeer()
{
  this->Parser.emplace(std::vector<IgtlParser::Kind>{{"IMAGE", MostImageBytes}});
  this->Sending.clear();
  this->SentBytes = 0;
  this->Told = IgtlTouch();
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->NextOffer = 0;
  this->IsNewestSent = !this->Newest;
  this->IsSent = this->Offers.empty() && this->IsNewestSent;
  this->IsConnected = true;
}

void IgtlLink::EndPeer(const char* problem)
{
  this->Parser.reset(); // first, since it may hold what is left of the memory
  this->Report(problem);
  this->IsConnected = false;
  this->Stream.Leave();
  this->IsOver = !this->Peer.Connects();
}

bool IgtlLink::IsFull()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->Images.size() >= MostWaitingImages;
}

void IgtlLink::Report(const std::string& problem)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (this->Problems.size() < MostProblems)
  {
    this->Problems.push_back(problem);
  }
}

// Returns false when the peer has ended.
bool IgtlLink::Receive()
{
  const std::ptrdiff_t count = this->Stream.Receive(this->Arrived.data(), this->Arrived.size());
  const std::uint64_t damaged = this->Parser->Damaged();
  const std::uint64_t tooLong = this->Parser->TooLong();
  if (count > 0 && !this->Parser->Take(this->Arrived.data(), static_cast<std::size_t>(count)))
  {
    this->EndPeer("The peer sends something that is not OpenIGTLink: check its address and port.");
    return false;
  }
  if (this->Parser->Damaged() > damaged)
  {
    this->Report("A damaged image was not used.");
  }
  if (this->Parser->TooLong() > tooLong)
  {
    this->Report("An image that the peer begins to send is not taken, since its message is longer "
                 "than 1 GiB: send a part of it, or fewer bytes a voxel.");
  }
  while (std::optional<IgtlMessage> message = this->Parser->Next())
  {
    IgtlImage image;
    const Status status = ReadIgtlImage(std::move(*message), image);
    if (!status.IsOk())
    {
      this->Report(status.Message());
      continue;
    }
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Images.push_back(std::move(image));
  }
  if (count < 0)
  {
    this->EndPeer("The OpenIGTLink peer is gone.");
    return false;
  }
  return true;
}

// The next message to be sent; false if there is none. Models, which may be large, come after news.
bool IgtlLink::PrepareNext()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->SentBytes = 0;
  this->Sending.clear();
  if (!this->IsNewestSent)
  {
    this->Sending = IgtlTouchMessages(this->Told, *this->Newest);
    this->Told = *this->Newest;
    this->IsNewestSent = true;
  }
  else if (this->NextOffer < this->Offers.size())
  {
    this->Sending = this->Offers[this->NextOffer++];
  }
  this->IsSent = this->Sending.empty();
  return !this->Sending.empty();
}

// Returns false if the connection has ended.
bool IgtlLink::Send()
{
  if (this->SentBytes == this->Sending.size() && !this->PrepareNext())
  {
    return true;
  }
  const std::ptrdiff_t sent = this->Stream.Send(this->Sending.data() + this->SentBytes,
                                                this->Sending.size() - this->SentBytes);
  this->SentBytes += sent > 0 ? static_cast<std::size_t>(sent) : 0;
  return sent >= 0;
}
} // namespace palpate

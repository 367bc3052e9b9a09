#include "StudyDevice.h"

#include "OpenBuiltInDevice.h"

#include <utility>

namespace palpate
{
StudyDevice::StudyDevice(Clock& clock, StudyJobs& jobs, Outcome outcome)
    : Time(clock), Jobs(jobs), Done(std::move(outcome))
{
}

void StudyDevice::Open(const std::string& name, bool isHeard)
{
  this->Cancel();
  this->Wanted = name;
  this->IsHeard = isHeard;
  this->Start();
}

void StudyDevice::Await(const std::string& problem)
{
  this->IsLost = true;
  this->Loss = problem;
  this->Tried = std::chrono::steady_clock::now();
}

void StudyDevice::TryAgain()
{
  constexpr std::chrono::milliseconds Pause(1000);
  if (this->IsLost && !this->Job && std::chrono::steady_clock::now() - this->Tried >= Pause)
  {
    this->Start();
  }
}

void StudyDevice::Cancel()
{
  if (this->Job)
  {
    this->Jobs.Cancel(*this->Job);
    this->Job.reset();
  }
  this->IsLost = false;
  this->Wanted.clear();
}

std::string StudyDevice::Notice() const
{
  const std::string loss = this->Loss.empty() ? "The device failed." : this->Loss;
  return this->IsLost ? loss + " Touch goes on once it is back." : "";
}

// A device that is still lost is tried again; its first loss is what a person is told.
void StudyDevice::Start()
{
  StudyJob job;
  job.IsUrgent = true;
  std::string silent = this->Wanted;
  const bool isHeard = TakeSound(silent) || this->IsHeard; // the device may ask for it itself
  job.Work = [this, name = silent + (isHeard ? "+sound" : ""),
              &clock = this->Time](const ProgressFunction&)
  {
    const auto device = std::make_shared<std::unique_ptr<HapticDevice>>();
    const Status status = OpenBuiltInDevice(name, clock, *device);
    return StudyJob::Delivery(
        [this, device, status]
        {
          this->Job.reset();
          this->Tried = std::chrono::steady_clock::now();
          if (status.IsOk() || !this->IsLost)
          {
            this->Done(status.IsOk() ? std::move(*device) : nullptr, status.Message());
          }
        });
  };
  job.Fail = [this](const std::string& message)
  {
    this->Job.reset();
    this->Tried = std::chrono::steady_clock::now();
    if (!this->IsLost)
    {
      this->Done(nullptr, message);
    }
  };
  this->Job = this->Jobs.Start(std::move(job));
}
} // namespace palpate

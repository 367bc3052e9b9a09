#include "RealtimeThread.h"

#include "RealtimeLimit.h"

#include <future>
#include <system_error>
#include <utility>

#include <pthread.h>

namespace palpate
{
namespace
{
void AskForPriority(int priority, RealtimeGrant& grant)
{
  // Set before the priority, so that there is never a priority without a limit.
  RealtimeLimit limit;
  sched_param parameters{};
  parameters.sched_priority = priority;
  const int error = pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters);
  grant.HasPriority = error == 0;
  if (grant.HasPriority)
  {
    limit.Keep();
  }
  if (error != 0)
  {
    grant.Advice = "Real-time priority " + std::to_string(priority) + " was refused (" +
                   std::generic_category().message(error) +
                   "): forces may be late when the machine is busy; allow it by 'rtprio' in "
                   "/etc/security/limits.d. ";
  }
}

RealtimeGrant AskFor(const RealtimeRequest& request)
{
  RealtimeGrant grant;
  if (request.Priority != 0)
  {
    AskForPriority(request.Priority, grant);
  }
  return grant;
}
} // namespace

Status RealtimeThread::Start(const RealtimeRequest& request, std::function<void()> body)
{
  if (this->Thread.joinable())
  {
    return Status::Failure("The real-time thread is already running.");
  }
  std::promise<RealtimeGrant> granted;
  std::future<RealtimeGrant> grant = granted.get_future();
  try
  {
    this->Thread = std::thread(
        [request, work = std::move(body), answer = std::move(granted)]() mutable
        {
          answer.set_value(AskFor(request));
          work();
        });
  }
  catch (const std::system_error& error)
  {
    return Status::Failure("The system cannot create a thread (" + std::string(error.what()) +
                           ").");
  }
  this->Given = grant.get();
  return Status::Success();
}

void RealtimeThread::Join()
{
  if (this->Thread.joinable())
  {
    this->Thread.join();
  }
}
} // namespace palpate

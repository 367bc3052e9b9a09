#include "TouchTrace.h"

#include <gtest/gtest.h>

#include <cmath>

namespace palpate::touch_trace_test
{
namespace
{
TouchStretch TickAt(std::size_t n)
{
  const auto force = static_cast<float>(std::sin(0.01 * static_cast<double>(n)));
  TouchStretch tick;
  tick.Time = 1e-3 * static_cast<double>(n);
  tick.Force = {force, force};
  return tick;
}

TouchTrace TraceOf(std::size_t ticks)
{
  TouchTrace trace;
  for (std::size_t n = 0; n < ticks; ++n)
  {
    trace.Add(TickAt(n));
  }
  return trace;
}

TEST(TouchTrace, HoldsEveryTickOfAShortTouch)
{
  const TouchTrace trace = TraceOf(TouchTrace::MostStretches);
  ASSERT_EQ(trace.Stretches().size(), TouchTrace::MostStretches);
  EXPECT_EQ(trace.TicksAStretch(), 1U);
  for (std::size_t n = 0; n < TouchTrace::MostStretches; ++n)
  {
    EXPECT_EQ(trace.Stretches()[n].Time, TickAt(n).Time);
    EXPECT_EQ(trace.Stretches()[n].Force.Most, TickAt(n).Force.Most);
  }
}

TEST(TouchTrace, DoesNotGrowWithTime)
{
  for (const std::size_t ticks : {TouchTrace::MostStretches + 1, std::size_t{1'000'003}})
  {
    const TouchTrace trace = TraceOf(ticks);
    EXPECT_LE(trace.Stretches().size(), TouchTrace::MostStretches);
    EXPECT_GE(trace.Stretches().size(), TouchTrace::MostStretches / 2);
    EXPECT_LE(trace.Stretches().capacity(), TouchTrace::MostStretches);
    EXPECT_EQ(trace.Duration(), TickAt(ticks - 1).Time);
  }
}

TEST(TouchTrace, EveryStretchHasMinimumAndMaximumOfItsTicks)
{
  constexpr std::size_t Ticks = 100'007;
  const TouchTrace trace = TraceOf(Ticks);
  const std::size_t length = trace.TicksAStretch();
  EXPECT_EQ(length, 8U);
  ASSERT_EQ(trace.Stretches().size(), (Ticks + length - 1) / length);
  LeastAndMost whole = TickAt(0).Force;
  for (std::size_t s = 0; s < trace.Stretches().size(); ++s)
  {
    LeastAndMost expected = TickAt(s * length).Force;
    for (std::size_t n = s * length; n < std::min(Ticks, (s + 1) * length); ++n)
    {
      expected.Join(TickAt(n).Force);
    }
    whole.Join(expected);
    EXPECT_EQ(trace.Stretches()[s].Time, TickAt(s * length).Time);
    EXPECT_EQ(trace.Stretches()[s].Force.Least, expected.Least);
    EXPECT_EQ(trace.Stretches()[s].Force.Most, expected.Most);
  }
  EXPECT_EQ(trace.Whole().Force.Least, whole.Least);
  EXPECT_EQ(trace.Whole().Force.Most, whole.Most);
}

TEST(TouchTrace, WithoutTicksIsEmpty)
{
  const TouchTrace trace;
  EXPECT_TRUE(trace.Stretches().empty());
  EXPECT_EQ(trace.Duration(), 0.0);
  EXPECT_EQ(trace.Whole().Force.Most, 0.0F);
}
} // namespace
} // namespace palpate::touch_trace_test

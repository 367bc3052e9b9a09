#include "ProbabilityDistributions.h"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized" // GCC 16 does not see what Boost sets
#endif
#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/students_t.hpp>
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

#include <cmath>

namespace palpate
{
namespace
{
// The callers give finite numbers and positive degrees; at the extremes the limit is wanted.
using Quiet = boost::math::policies::policy<
    boost::math::policies::domain_error<boost::math::policies::ignore_error>,
    boost::math::policies::overflow_error<boost::math::policies::ignore_error>,
    boost::math::policies::evaluation_error<boost::math::policies::ignore_error>>;
using Student = boost::math::students_t_distribution<double, Quiet>;
using Beta = boost::math::beta_distribution<double, Quiet>;
using Fisher = boost::math::fisher_f_distribution<double, Quiet>;
} // namespace

double StudentTwoSided(double t, double degrees)
{
  if (std::isnan(t))
  {
    return 1.0;
  }
  return std::isinf(t)
             ? 0.0
             : 2.0 * boost::math::cdf(boost::math::complement(Student(degrees), std::abs(t)));
}

double StudentQuantile(double confidence, double degrees)
{
  return boost::math::quantile(boost::math::complement(Student(degrees), 0.5 * (1.0 - confidence)));
}

double FisherUpper(double f, double numerator, double denominator)
{
  if (std::isnan(f) || f <= 0.0)
  {
    return 1.0;
  }
  return std::isinf(f)
             ? 0.0
             : boost::math::cdf(boost::math::complement(Fisher(numerator, denominator), f));
}

double FisherUpperQuantile(double probability, double numerator, double denominator)
{
  // d / (d + n F) is beta distributed, and small where F is large.
  const Beta beta(0.5 * denominator, 0.5 * numerator);
  const double part = boost::math::quantile(beta, probability);
  return denominator / numerator * (1.0 - part) / part;
}
} // namespace palpate

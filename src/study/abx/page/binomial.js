// How probable right answers are by guessing.

/// Probability of at least `right` right answers in `trials` with a chance of 1/2 each: the one-sided p-value of the binomial test.
function chanceByGuessing(right, trials) {
  let sum = 0, term = 0.5 ** trials;  // of n right answers
  for (let n = trials; n >= right; --n) {
    sum += term;
    term *= n / (trials - n + 1);
  }
  return sum;
}

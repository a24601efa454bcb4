#include "faust_nodes.hpp"

#include <fmt/format.h>

namespace idiophone::timbre {

// The waves are those of oscillators.cpp, the filters those of filters.cpp, and so on: where no noise is involved, both
// programs compute the same numbers. Faust refuses constants that are divided by zero, even where they are not used.
const char* faust_definitions() {
  return R"(import("stdfaust.lib");

time = ba.time/ma.SR;
integral(x) = (x : + ~ _) : mem;                                  // of the samples before
phase(f) = (f/ma.SR : (+ : ma.frac) ~ _) : mem;                   // in cycles
audible(f) = abs(f) < 0.5*ma.SR;
square_of(x) = x*x;
newton(u, y, first, second, third) = y + u*(first + (u - 1.0)/2.0*(second + (u - 2.0)/3.0*third));

// Edges smoothed by a cubic B-spline; i is the increment of the phase p in a sample.
rise(b) = select2(b < -1.0, 0.5 + b*(2.0/3.0 - b*b/3.0 - b*b*b/8.0), square_of(square_of(2.0 + b))/24.0);
step(x) = select2(x < 0.0, -1.0, 1.0)*rise(max(-2.0, 0.0 - abs(x)));
bend(b) = select2(b < -1.0, 7.0/30.0 + b*0.5 + b*b/3.0 - square_of(b*b)*(1.0/12.0 + b/40.0),
                  (2.0 + b)*square_of(square_of(2.0 + b))/120.0);
kink(x) = bend(max(-2.0, 0.0 - abs(x)));
edges(p, i, residual) = (residual(ma.frac(p)/safe) + residual((ma.frac(p) - 1.0)/safe))*(i != 0.0)
with { safe = i + (i == 0.0); };
sawtooth(p, i) = sign*(2.0*ma.frac(sign*p) - 1.0 - 2.0*edges(sign*p, sign*i, step)) with { sign = select2(i < 0.0, 1.0, -1.0); };
square(p, i, duty) = sawtooth(p - duty, i) - sawtooth(p, i) + 2.0*duty - 1.0;
triangle(p, i) = 1.0 - 4.0*abs(ma.frac(p) - 0.5) + 8.0*abs(i)*(edges(p, i, kink) - edges(p - 0.5, i, kink));

// Noises, from white noise w of root mean square sqrt(1/3).
pole_and_zero(f, x) = x : fi.zero(exp(-4.0*ma.PI*f/ma.SR)) : fi.pole(exp(-2.0*ma.PI*f/ma.SR));
pink(w) = 1.0469*w : seq(k, 6, pole_and_zero(pow(4.0, k + 1)));    // root mean square 1 at 44.1 kHz
perlin(w, f) = 2.0*(left + fade*(right - left))
with {
  x = phase(f);
  begins = x < x';
  slope = w : ba.sAndH(begins | (time == 0.0));
  slope_before = slope' : ba.sAndH(begins);
  left = slope_before*x;
  right = slope*(x - 1.0);
  fade = x*x*x*(x*(6.0*x - 15.0) + 10.0);
};
markov(w, f, damping) = sqrt(3.0)*scale*w : fi.tf2(1.0, 0.0, 0.0, 0.0 - 2.0*exp(0.0 - decay)*cos(turn), memory)
with {
  decay = 2.0*ma.PI*f*damping/ma.SR;
  turn = 2.0*ma.PI*f*sqrt(1.0 - damping*damping)/ma.SR;
  memory = exp(-2.0*decay);
  loss = 1.0 - memory;
  scale = sqrt(loss*(loss*loss + 4.0*memory*square_of(sin(turn)))/(1.0 + memory));
};

// Filters and delays.
lowpass(x, f) = x*(1.0 - b) : fi.pole(b) with { b = exp(-2.0*ma.PI*f/ma.SR); };
transmit(x, m) = x : fi.tf1(0.5*(1.0 - pole + at_half_rate), 0.5*(1.0 - pole - at_half_rate), 0.0 - pole)
with {
  corner = 415.0/(ma.PI*m*ma.SR);
  pole = exp(0.0 - 2.0*ma.PI*corner);
  at_half_rate = (1.0 + pole)/sqrt(1.0 + square_of(0.5/corner));
};
reading(n, x, d) = sum(k, 32, weight(lag(k) - d)*de.delay(n, max(0, lag(k)), x))
with {
  lag(k) = int(floor(d)) + k - 15;
  weight(s) = sinc(ma.PI*s)*square_of(cos(ma.PI*s/32.0));
  sinc(a) = select2(abs(a) < 1e-9, sin(a)/(a + (abs(a) < 1e-9)), 1.0);
};
reverberate(x, decay) = (reflect : par(l, 8, +(x))) ~ par(l, 8, line(l, 1)) : par(l, 8, line(l, 0)*(1 - 2*(l % 2))) :>
                        /(sqrt(8.0))
with {
  reflect = si.bus(8) <: si.bus(8), (si.bus(8) :> *(0.25) <: si.bus(8)) : ro.interleave(8, 2) : par(l, 8, -);
  line(l, done) = @(samples(l) - done) : *(pow(10.0, -3.0*samples(l)/(ma.SR*decay)));
  samples(l) = int(ba.take(l + 1, lengths)*ma.SR + 0.5) | 1;
  lengths = (0.02973, 0.03319, 0.03711, 0.04111, 0.04537, 0.05077, 0.05623, 0.06287);
};

)";
}

const std::map<std::string, std::string>& faust_nodes() {
  static const std::map<std::string, std::string> nodes = {
      {"pow", "pow($0, $1)"},
      {"mod", "($0 - $1*floor($0/$1))"},
      {"abs", "abs($0)"},
      {"sign", "float(($0 > 0.0) - ($0 < 0.0))"},
      {"floor", "floor($0)"},
      {"sqrt", "sqrt($0)"},
      {"exp", "exp($0)"},
      {"log", "log($0)"},
      {"sin", "sin($0)"},
      {"cos", "cos($0)"},
      {"tanh", "ma.tanh($0)"},
      {"decibels", "pow(10.0, $0/20.0)"},
      {"clip", "min(max($0, $1), $2)"},
      {"less", "float($0 < $1)"},
      {"select", "select2($0 > 0.0, $2, $1)"},
      {"sine", "sin(2.0*ma.PI*(phase($0) + $1))*audible($0)"},
      {"sawtooth", "sawtooth(phase($0) + $1, $0/ma.SR)*audible($0)"},
      {"triangle", "triangle(phase($0) + $1, $0/ma.SR)*audible($0)"},
      {"square", "square(phase($0), $0/ma.SR, $1)*audible($0)"},
      {"white", "$n"},
      {"pink", "pink($n)"},
      {"perlin", "perlin($n, $0)"},
      {"markov", "markov($n, $0, $1)"},
      {"lowpass", "lowpass($0, $1)"},
      {"highpass", "($0 - lowpass($0, $1))"},
      {"bandpass", "($0 : fi.svf.bp($1, $2) : /($2))"},
      {"biquad", "($0 : fi.tf22t($1, $2, $3, $4, $5))"},
      {"transmit", "transmit($0, $1)"},
      {"delay", "reading(int($2*192000.0) + 32, $0, $1*ma.SR)"},
      {"reverberate", "reverberate($0, $1)"},
      {"damp", "exp(0.0 - integral(2.0*ma.PI*$0*$1/ma.SR))"},
      {"timer", "select2((time >= $0) & (time < $1), 0.0, $2)"},
      {"time", "time"},
  };
  return nodes;
}

std::string faust_join(const std::string& node, const std::vector<std::string>& arguments) {
  const bool is_function = node == "min" || node == "max";
  if (!is_function && node != "+" && node != "-" && node != "*" && node != "/") {
    return "";
  }
  std::string text = arguments.front();
  if (arguments.size() == 1) {
    return node == "-" ? fmt::format("(0.0 - {})", text) : node == "/" ? fmt::format("(1.0 / {})", text) : text;
  }
  for (std::size_t a = 1; a < arguments.size(); ++a) {
    text = is_function ? fmt::format("{}({}, {})", node, text, arguments[a])
                       : fmt::format("({} {} {})", text, node, arguments[a]);
  }
  return text;
}

}  // namespace idiophone::timbre

"use strict";
// The modes of a body by the program's own C++, which src/instruments/page_sound/exports.cpp shows to this file. It
// runs in the page and in the audio thread.

/// The functions of the C++. All bodies of a thread share them.
/// @param bytes  of the WebAssembly
function compiledCode(bytes) {
  const {exports} = new WebAssembly.Instance(new WebAssembly.Module(bytes));
  exports._initialize();
  return exports;
}

/// The same in the page, where some browsers do not let a script wait for so much code.
async function loadedCode(bytes) {
  const {instance: {exports}} = await WebAssembly.instantiate(bytes);
  exports._initialize();
  return exports;
}

/// What exchanges numbers with the C++.
class Compiled {
  /// @param code  compiledCode()
  constructor(code) {
    this.code = code;
  }

  /// The list through which numbers go to the C++ and back.
  numbers(length) {
    const place = this.code.exchange(length);  // may enlarge the memory, which then is another buffer
    return new Float64Array(this.code.memory.buffer, place, length);
  }

  give(...lists) {
    const numbers = this.numbers(lists.reduce((sum, {length}) => sum + length, 0));
    lists.reduce((at, list) => {
      numbers.set(list, at);
      return at + list.length;
    }, 0);
  }
}

/// As Modes, and bows can touch them.
class CompiledModes extends Compiled {
  /// @param tuning      as of Modes, and size of the body over that of its map
  /// @param stretching  as of readBody(), if vibrations may be large
  constructor(code, tuning, rate, stretching = null) {
    super(code);
    this.modes = tuning.frequency.length;
    this.channels = tuning.pressure.length;
    this.body = stretching ? this.stretched(stretching, rate) : code.make_body(this.modes, this.channels, rate);
    this.tune(tuning);
  }

  stretched({linear, rotation, places, values}, rate) {
    this.give(linear, rotation, places, values);
    return this.code.make_stretched_body(this.modes, this.channels, rate, linear.length / this.modes, places.length);
  }

  tune({frequency, decay, pressure, size = 1}) {
    this.give(frequency, decay, ...pressure);
    this.code.tune(this.body, this.modes, this.channels, size);
  }

  /// The largest angle by which large vibrations turned the parts of the body, root mean square, rad.
  rotation() {
    return this.code.rotation(this.body);
  }

  strike({start, force: {mean, slope, begin}, participation}) {
    this.give(participation, mean, slope, begin);
    this.code.strike(this.body, this.modes, start, mean.length);
  }

  /// A bow begins to touch the body, but neither moves nor presses yet.
  /// @param bow  a number that no other bow of the body has
  putBow(bow, participation) {
    this.give(participation);
    this.code.put_bow(this.body, this.modes, bow);
  }

  /// It gets there in 20 ms.
  leadBow(bow, {speed, load}, participation) {
    this.give(participation);
    this.code.lead_bow(this.body, this.modes, bow, speed, load);
  }

  liftBow(bow) {
    this.code.lift_bow(this.body, bow);
  }

  render(first, samples) {
    if (!this.code.render(this.body, this.channels, first, samples)) return null;
    const sound = this.numbers(samples * this.channels);
    return Array.from({length: this.channels}, (_, channel) =>
      Float64Array.from({length: samples}, (_unused, i) => sound[i * this.channels + channel]));
  }
}

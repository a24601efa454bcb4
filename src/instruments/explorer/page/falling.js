// Bodies that fall on the ground and on each other, and what of it can be heard.

const gravity = 9.81;        // m/s^2
const restingWay = 0.05;     // of the reach of a body: what does not go farther
const restingTime = 0.5;     // in so many seconds rests
const oneContact = 0.7;      // of the reach of a body: what touches nearer to another place is the same contact
const rememberedTime = 0.1;  // s, that a contact may let go and stay the same

class Falling {
  /// @param bodies  RigidBody
  /// @param ground  its height, m; -Infinity: none
  /// @param bounce, friction  as of applyImpulses()
  constructor(bodies, ground, {bounce = 0.4, friction = 0.4, weight = gravity} = {}) {
    Object.assign(this, {bodies, ground, bounce, friction, weight, still: 0, time: 0, touching: [], numbers: 0});
    this.before = bodies.map(({position, rows}) => ({position, rows}));
    this.skin = bodies.reduce((least, {reach}) => Math.min(least, 0.02 * reach), 2e-3);
  }

  get isAtRest() {
    return this.still >= restingTime;
  }

  /// Whether all bodies are where they were when one of them last was not.
  rests() {
    const stays = this.bodies.every(({position, rows, reach}, i) => {
      const {before: {[i]: before}} = this, most = restingWay * reach;
      return lengthOf(minus(position, before.position)) < most && rows.every((row, axis) => reach * lengthOf(minus(row, before.rows[axis])) < most);
    });
    if (!stays) this.before = this.bodies.map(({position, rows}) => ({position, rows}));
    return stays;
  }

  /// What happens in the next `duration` (s), as contacts that ContactSounds takes.
  step(duration) {
    for (const body of this.bodies) body.velocity = plus(body.velocity, [0, 0, -this.weight * duration]);
    const contacts = findContacts(this.bodies, this.ground, this.skin, duration);
    applyImpulses(contacts, this.bounce, this.friction);
    resistRolling(contacts, duration);
    for (const body of this.bodies) body.advance(duration);
    separate(contacts);
    this.time += duration;
    this.touching = this.touching.filter(({last}) => this.time - last < rememberedTime);
    this.still = this.rests() ? this.still + duration : 0;
    return contacts.filter(({impulse}) => impulse > 0).map(contact => this.eventOf(contact));
  }

  /// Of the contact of the same two bodies that was nearest a short time ago, as seen from the owner's centre: so a body that rolls
  /// or slides has the same contact all the time, and the corners of a box have one each.
  numberOf({owner, other, arms: [arm]}) {
    const away = known => lengthOf(minus(known.arm, arm)), near = this.touching.filter(
      known => known.owner === owner && known.other === other && away(known) < oneContact * owner.reach);
    let nearest = near.sort((a, b) => away(a) - away(b))[0];
    if (!nearest) this.touching.push(nearest = {owner, other, number: this.numbers++});
    Object.assign(nearest, {arm, last: this.time});
    return nearest.number;
  }

  /// As include/idiophone/instruments/touching/contact_events.hpp has it.
  eventOf(contact) {
    const {owner, other, place, normal, impulse, slip, roll, mass, moment, depth} = contact;
    const pair = [owner, other].map(body => this.bodies.indexOf(body));  // -1: the ground
    return {contact: this.numberOf(contact), bodies: pair, point: place, normal, impulse, slip, roll, mass, moment: depth > 0 ? 0 : moment};
  }
}

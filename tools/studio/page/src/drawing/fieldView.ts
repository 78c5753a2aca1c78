// SPDX-License-Identifier: Apache-2.0
// The field in 3D at one moment: stadium, robots, ball, beliefs and names. It keeps no time of its
// own: what it is given it shows, and moves the view there.
import * as THREE from "three";
import names from "kelpie:names";
import { BodyTree, type Body } from "../model/body";
import type { Field, Point } from "../model/field";
import type { Moment, RobotMoment } from "../model/moment";
import { drawBeliefs, type Layer } from "./beliefs";
import { NameTags } from "./nameTags";
import { Ribbons } from "./ribbons";
import { ContactShadows, NumberPlates, RobotMeshes, type ShownRobot } from "./robots";
import { coloured } from "./shapes";
import { Stage } from "./stage";
import { makeStadium, type Stadium } from "./stadium";
import { VIEWS, Views, cameraPlace, type ViewName } from "./views";

export interface Shown {
  robots: number;
  ghosts: number;
  lines: number; // painted on the field
  beliefs: number; // lines, ellipses and squares of beliefs
}

const BALL_PAINT = 0xff6a13;
const JUMP = 1.5e6; // us
const AFTER_PAUSE = 0.25; // s; a longer time between two pictures is a pause, not a slow machine

export class FieldView {
  readonly stage: Stage;
  readonly views: Views;
  readonly tree: BodyTree;
  readonly layers = new Set<Layer>(["robots", "names", "ball", "aim", "arrows"]);
  readonly shown: Shown = { robots: 0, ghosts: 0, lines: 0, beliefs: 0 };
  selected = "";
  private moment: Moment | undefined;
  private dragged: Point | undefined;
  private readonly stadium: Stadium;
  private readonly real: RobotMeshes;
  private readonly ghosts: RobotMeshes;
  private readonly plates: NumberPlates;
  private readonly contacts = new ContactShadows();
  private readonly ink = new Ribbons();
  private readonly ball: THREE.Mesh;
  private readonly tags: NameTags;
  private drawnAt = 0;

  constructor(
    canvas: HTMLCanvasElement,
    over: HTMLElement,
    readonly field: Field,
    body: Body,
    onPick: (key: string) => void,
  ) {
    this.stage = new Stage(canvas, () => this.prepare());
    this.tree = new BodyTree(body);
    this.views = new Views(this.stage.camera, canvas, field, this.tree, () =>
      this.stage.invalidate(),
    );
    this.stadium = makeStadium(field);
    this.real = new RobotMeshes(this.tree, false);
    this.ghosts = new RobotMeshes(this.tree, true);
    this.plates = new NumberPlates(this.tree);
    this.ball = makeBall();
    this.tags = new NameTags(over, onPick);
    this.stage.scene.add(
      this.stadium.group,
      this.real.group,
      this.ghosts.group,
      this.ball,
      this.contacts.mesh,
      this.plates.group,
      this.ink.mesh,
    );
    this.stage.lightField(field.width, field.length);
    this.shown.lines = this.stadium.lineCount;
  }

  show(moment: Moment): void {
    const before = this.moment;
    const appears = moment.ball !== undefined && before?.ball === undefined;
    if (before && (appears || Math.abs(moment.time - before.time) > JUMP)) this.views.jump();
    this.moment = moment;
    this.stage.invalidate();
  }

  setView(mode: ViewName): void {
    this.views.setMode(mode);
    this.stage.invalidate();
  }

  nextView(): ViewName {
    const next = VIEWS[(VIEWS.indexOf(this.views.mode) + 1) % VIEWS.length]!;
    this.setView(next);
    return next;
  }

  setLayer(layer: Layer, on: boolean): void {
    if (on) this.layers.add(layer);
    else this.layers.delete(layer);
    this.stage.invalidate();
  }

  // What is drawn of a robot where it really is, or else where it believes to be.
  shownRobot(robot: RobotMoment, place = robot.truth ?? robot.belief): ShownRobot | undefined {
    if (!place) return undefined;
    return {
      pose: place,
      team: robot.team,
      player: robot.player,
      joints: robot.joints ?? this.standing(),
      stance: robot.stance,
      hideHead: this.views.mode === "eye" && robot.key === this.selected,
    };
  }

  // Joints of a robot without a log: those of another, or what the server says of standing.
  private standing(): readonly number[] {
    return this.moment?.robots.find((r) => r.joints)?.joints ?? this.tree.body.stance?.joints ?? [];
  }

  // Where something that is dragged would be put.
  dragTo(place: Point | undefined): void {
    this.dragged = place;
    this.stage.invalidate();
  }

  private prepare(): void {
    const moment = this.moment;
    if (!moment) return;
    const now = performance.now() / 1000;
    const seconds = Math.min(AFTER_PAUSE, this.drawnAt > 0 ? now - this.drawnAt : AFTER_PAUSE);
    this.drawnAt = now;
    this.stadium.arrows.visible = this.layers.has("arrows");
    this.stage.sun.castShadow = this.layers.has("shadows");
    this.showRobots(moment);
    this.showBall(moment);
    this.showInk(moment);
    const chosen = moment.robots.find((r) => r.key === this.selected);
    const robot = chosen && this.shownRobot(chosen);
    if (this.views.step(robot, moment.ball, seconds)) this.stage.invalidate();
    this.stage.camera.updateMatrixWorld();
    this.tags.show(
      this.layers.has("names") ? moment.robots : [],
      this.selected,
      this.stage.camera,
      this.views.mode === "eye" ? this.selected : "",
    );
  }

  private showRobots(moment: Moment): void {
    const real = this.layers.has("robots")
      ? moment.robots.flatMap((r) => this.shownRobot(r) ?? [])
      : [];
    const ghosts = this.layers.has("ghosts")
      ? moment.robots.flatMap(
          (r) => (r.truth && r.belief ? this.shownRobot(r, r.belief) : undefined) ?? [],
        )
      : [];
    this.real.show(real);
    this.ghosts.show(ghosts);
    this.plates.show(real);
    this.contacts.show(this.layers.has("shadows") ? [] : real, moment.ball);
    this.shown.robots = real.length;
    this.shown.ghosts = ghosts.length;
  }

  private showBall(moment: Moment): void {
    this.ball.visible = moment.ball !== undefined;
    if (!moment.ball) return;
    const radius = names.numbers["kBallRadius"]!;
    const { x, y } = moment.ball;
    this.ball.position.set(x, y, radius);
    // It rolls: the turn is that of a sphere that came here from the origin.
    this.ball.rotation.set(-y / radius, x / radius, 0);
  }

  private showInk(moment: Moment): void {
    this.ink.clear();
    for (const robot of moment.robots) {
      const mine = robot.key === this.selected;
      const layers =
        mine || this.selected === ""
          ? this.layers
          : new Set([...this.layers].filter((l) => l === "aim"));
      drawBeliefs(robot, this.field, layers, this.ink);
      if (mine) this.mark(robot);
    }
    if (this.dragged) this.ink.ring(this.dragged, 9, 2, 0xffffff);
    this.ink.finish();
    this.shown.beliefs = this.ink.count;
  }

  // A ring below the selected robot, and the part of the carpet that its camera sees.
  private mark(robot: RobotMoment): void {
    const shown = this.shownRobot(robot);
    if (!shown || this.views.mode === "eye") return;
    const middle = {
      x: shown.pose.x - 7 * Math.cos(shown.pose.heading),
      y: shown.pose.y - 7 * Math.sin(shown.pose.heading),
    };
    this.ink.ring(middle, 17, 0.8, 0xffffff, 0.85);
    if (this.layers.has("frustum")) this.frustum(shown);
  }

  private frustum(robot: ShownRobot): void {
    const place = cameraPlace(robot, this.tree);
    const [across, down] = this.tree.body.camera?.opening ?? [1, 0.8];
    const from = new THREE.Vector3().setFromMatrixPosition(place);
    const corners = [
      [-1, -1],
      [1, -1],
      [1, 1],
      [-1, 1],
    ].map(([x, z]) => {
      const ray = new THREE.Vector3(
        x! * Math.tan(across / 2),
        1,
        z! * Math.tan(down / 2),
      ).transformDirection(place);
      const way = ray.z < -0.01 ? Math.min(500, -from.z / ray.z) : 500;
      return { x: from.x + way * ray.x, y: from.y + way * ray.y };
    });
    const [a, b, c, d] = corners as [THREE.Vector2, THREE.Vector2, THREE.Vector2, THREE.Vector2];
    this.ink.triangle(a, b, c, 0xffffff, 0.14, 0.5);
    this.ink.triangle(a, c, d, 0xffffff, 0.14, 0.5);
    corners.forEach((p, i) => this.ink.line(p, corners[(i + 1) % 4]!, 0.8, 0xffffff, 0.6));
  }
}

function makeBall(): THREE.Mesh {
  const radius = names.numbers["kBallRadius"]!;
  const ball = new THREE.Mesh(
    coloured(new THREE.SphereGeometry(radius, 24, 16), BALL_PAINT),
    new THREE.MeshLambertMaterial({ vertexColors: true }),
  );
  ball.castShadow = true;
  return ball;
}

// SPDX-License-Identifier: Apache-2.0
// Names over the robots as elements of the page, so that they are sharp and can be chosen by
// pointer. The number and the team's letter stand in the tag, as colour alone tells not everybody.
import * as THREE from "three";
import { TEAM_NAMES } from "../model/field";
import type { RobotMoment } from "../model/moment";
import { decisionsOf, roleName } from "../model/words";
import { numberAt } from "../reading/access";

const OVER = 30; // cm

export class NameTags {
  private readonly tags = new Map<string, HTMLButtonElement>();
  private readonly point = new THREE.Vector3();

  constructor(
    private readonly over: HTMLElement,
    private readonly onPick: (key: string) => void,
  ) {}

  show(robots: readonly RobotMoment[], selected: string, camera: THREE.Camera, hide: string): void {
    const width = this.over.clientWidth;
    const height = this.over.clientHeight;
    const seen = new Set<string>();
    for (const robot of robots) {
      const pose = robot.truth ?? robot.belief;
      if (!pose || robot.key === hide) continue;
      this.point.set(pose.x, pose.y, OVER).project(camera);
      if (this.point.z > 1 || Math.abs(this.point.x) > 1.05 || Math.abs(this.point.y) > 1.05)
        continue;
      seen.add(robot.key);
      this.place(
        this.tag(robot),
        robot,
        selected,
        ((this.point.x + 1) / 2) * width,
        ((1 - this.point.y) / 2) * height,
      );
    }
    for (const [key, tag] of this.tags) tag.hidden = !seen.has(key);
  }

  private tag(robot: RobotMoment): HTMLButtonElement {
    let tag = this.tags.get(robot.key);
    if (tag) return tag;
    tag = document.createElement("button");
    tag.type = "button";
    tag.className = `tag ${TEAM_NAMES[robot.team]}`;
    tag.tabIndex = -1; // the list of robots is the way by keyboard
    tag.innerHTML = "<b></b><span></span>";
    tag.addEventListener("click", () => this.onPick(robot.key));
    this.over.append(tag);
    this.tags.set(robot.key, tag);
    return tag;
  }

  private place(
    tag: HTMLButtonElement,
    robot: RobotMoment,
    selected: string,
    x: number,
    y: number,
  ): void {
    const role = roleName(numberAt(robot.output, "command.team.role"));
    const doing = robot.key === selected ? skillOf(robot) : role === "none" ? "" : role;
    setText(tag.firstElementChild!, String(robot.player));
    setText(tag.lastElementChild!, doing);
    tag.setAttribute("aria-label", `${TEAM_NAMES[robot.team]} ${robot.player} ${doing}`);
    tag.classList.toggle("selected", robot.key === selected);
    tag.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px) translate(-50%, -100%)`;
  }
}

function skillOf(robot: RobotMoment): string {
  const trace = decisionsOf(robot.output?.["command"] as never);
  const skill = trace.filter((d) => d.layer === "skill")[0] ?? trace[trace.length - 1];
  return skill ? `${skill.module}: ${skill.branch}` : "";
}

function setText(element: Element, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}
